#pragma once

// Recursive least squares that forgets only where samples say something new, so that the covariance stays bounded without
// excitation and without a limit imposed on it. Bounds and their proofs: docs/derivations/directional-forgetting.md.

#include "core/result.hpp"
#include "estimation/estimator_params.hpp"
#include "estimation/regression.hpp"

namespace farrier::estimation {

/// Settings of both methods. Unit: that of the normalised signals, 1.
struct DirectionalParams {
  double forgetting_factor = 0.998;  ///< lambda, (0, 1], of the directions that are forgotten
  double initial_covariance = 1e5;   ///< diagonal of the first P, [1e-40, 1e40]
  double excitation_min = 1e-3;      ///< epsilon: excitation threshold of a regressor, [1e-20, 1e20]
};

/// Settings of a joint's estimator.
inline DirectionalParams directional_params_of(const EstimatorParams& params, double excitation_min) noexcept {
  return {.forgetting_factor = params.forgetting_factor,
          .initial_covariance = params.initial_covariance,
          .excitation_min = excitation_min};
}

/// Common part of both methods: the information matrix R = P^-1 and least squares in its terms. N = 3..5.
template <int N>
class InformationFilter : public Regression<N> {
 public:
  using typename Regression<N>::Regressor;
  using typename Regression<N>::Parameters;
  using typename Regression<N>::Covariance;

  /// P, the same for every row.
  Covariance covariance(int = 0) const noexcept;

  double covariance_trace() const noexcept { return covariance().trace(); }

  /// R, symmetric.
  const Covariance& information() const noexcept { return r_; }

  /// Lower bound of the eigenvalues of R for any samples: min(1 / P_0, epsilon^2 / (1 - lambda)).
  double information_floor() const noexcept;

 protected:
  InformationFilter(const DirectionalParams& params, const Parameters& theta0) noexcept;
  static std::optional<Error> check(const char* method, const DirectionalParams& params, const Parameters& theta0);

  /// R <- remembered + h h', Theta <- Theta + e (R^-1 h)'.
  RlsStatus absorb(const Covariance& remembered, const Regressor& h, const Eigen::Vector3d& e, double lambda) noexcept;

  DirectionalParams params_;
  Covariance r_;
};

/// Variable-direction forgetting (Goel, Bruce, Bernstein 2020, "Recursive least squares with variable-direction
/// forgetting", IEEE Control Systems Magazine 40(4)). Only those eigenvectors of R are forgotten along which the
/// regressor has more than excitation_min. Here forgetting stops at information_floor(): a regressor that lies between
/// several eigenvectors removes more information than it adds.
template <int N>
class VariableDirection : public InformationFilter<N> {
 public:
  using typename InformationFilter<N>::Regressor;
  using typename InformationFilter<N>::Parameters;
  using typename InformationFilter<N>::Covariance;

  static Result<VariableDirection> create(const DirectionalParams& params,
                                          const Parameters& theta0 = Parameters::Zero());

  /// Its method, and create() with the settings of a joint's estimator; `noise_variance` is the sensors', normalised.
  static constexpr EstimationMethod kMethod = EstimationMethod::kVdf;
  static Result<VariableDirection> of(const EstimatorParams& params, const Eigen::Vector3d&, const Parameters& theta0) {
    return create(directional_params_of(params, params.vdf.value_or(VariableDirectionParams{}).excitation_min), theta0);
  }

  RlsStatus update(const Regressor& h, const Eigen::Vector3d& y) noexcept;

 private:
  using InformationFilter<N>::InformationFilter;
};

/// SIFt-RLS, forgetting in the subspace of information (Lai and Bernstein 2024, arXiv 2404.10844), with one regressor:
/// only the information of R along h is forgotten. A regressor shorter than excitation_min is left out. As long as
/// |h|^2 <= beta no eigenvalue of R is above information_ceiling(beta).
template <int N>
class SubspaceOfInformation : public InformationFilter<N> {
 public:
  using typename InformationFilter<N>::Regressor;
  using typename InformationFilter<N>::Parameters;
  using typename InformationFilter<N>::Covariance;

  static Result<SubspaceOfInformation> create(const DirectionalParams& params,
                                              const Parameters& theta0 = Parameters::Zero());

  /// Its method, and create() with the settings of a joint's estimator; `noise_variance` is the sensors', normalised.
  static constexpr EstimationMethod kMethod = EstimationMethod::kSift;
  static Result<SubspaceOfInformation> of(const EstimatorParams& params, const Eigen::Vector3d&,
                                          const Parameters& theta0) {
    return create(directional_params_of(params, params.sift.value_or(SubspaceParams{}).excitation_min), theta0);
  }

  RlsStatus update(const Regressor& h, const Eigen::Vector3d& y) noexcept;

  /// max(1 / P_0, beta / (1 - lambda)).
  double information_ceiling(double beta) const noexcept;

 private:
  using InformationFilter<N>::InformationFilter;
};

}  // namespace farrier::estimation
