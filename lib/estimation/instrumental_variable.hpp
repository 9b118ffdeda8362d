#pragma once

#include "core/result.hpp"
#include "estimation/regression.hpp"
#include "estimation/rls.hpp"

namespace farrier::estimation {

/// Recursive instrumental variables (Hubacher 2014, B.3.2, (B.18); Soderstrom and Stoica 1983): where the regressor h is
/// measured with noise, products with an instrument xi, which follows the true regressor and not its noise, have no bias.
/// P = (sum xi h')^-1 is not symmetric; what stands for it in errors is P M P' with M = sum xi xi', which is P where
/// xi = h. N = 3..5.
template <int N>
class InstrumentalVariable : public Regression<N> {
 public:
  using typename Regression<N>::Regressor;
  using typename Regression<N>::Parameters;
  using typename Regression<N>::Covariance;

  /// Forgetting and covariance as in RlsParams, whose regressor_min must be 0. Refuses settings out of range by name.
  static Result<InstrumentalVariable> create(const RlsParams& params, const Parameters& theta0 = Parameters::Zero());

  /// Takes one sample. An instrument that is not finite, much larger than the regressor, or with which the sample would
  /// take away information (h'P xi < 0) is replaced by h: least squares for this sample, and instrument_refused(). Where
  /// that takes away information too, P means nothing any more and is begun anew.
  RlsStatus update(const Regressor& h, const Eigen::Vector3d& y, const Regressor& instrument) noexcept;

  /// P M P', the same for every row.
  Covariance covariance(int = 0) const noexcept;

  double covariance_trace() const noexcept { return covariance().trace(); }

  bool instrument_refused() const noexcept { return refused_; }

 private:
  InstrumentalVariable(const RlsParams& params, const Parameters& theta0) noexcept;
  void begin_anew() noexcept;

  RlsParams params_;
  Covariance p_;  // not symmetric
  Covariance m_;  // sum of lambda^(n-k) xi xi'
  bool refused_ = false;
};

}  // namespace farrier::estimation
