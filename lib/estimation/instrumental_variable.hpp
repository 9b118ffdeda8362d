#pragma once

#include "core/result.hpp"
#include "estimation/regression.hpp"
#include "estimation/rls.hpp"

namespace farrier::estimation {

/// Recursive instrumental variables (Hubacher 2014, B.3.2, (B.18); Soderstrom and Stoica 1983), for a regressor h
/// measured with noise. An instrument xi follows the true regressor and not its noise, so products with it have no
/// bias. P = (sum xi h')^-1 is not symmetric. Errors use P M P' with M = sum xi xi' instead, which equals P if xi = h.
/// N = 3..5.
template <int N>
class InstrumentalVariable : public Regression<N> {
 public:
  using typename Regression<N>::Regressor;
  using typename Regression<N>::Parameters;
  using typename Regression<N>::Covariance;

  /// Forgetting and covariance as in RlsParams, whose regressor_min must be 0. Refuses settings out of range by name.
  static Result<InstrumentalVariable> create(const RlsParams& params, const Parameters& theta0 = Parameters::Zero());

  /// Its method, and create() with the settings of a joint's estimator; `noise_variance` is the sensors', normalised.
  static constexpr EstimationMethod kMethod = EstimationMethod::kIv;
  static Result<InstrumentalVariable> of(const EstimatorParams& params, const Eigen::Vector3d&,
                                         const Parameters& theta0) {
    return create(rls_params_of(params), theta0);
  }

  /// Takes one sample. The instrument is replaced by h if it is not finite, much larger than the regressor, or would
  /// remove information (h'P xi < 0). The sample is then a least-squares one, and instrument_refused() is true. If h
  /// removes information too, P has become meaningless and is reset.
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
