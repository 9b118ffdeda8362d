#include "estimation/directional_forgetting.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <string>

#include "control/numerics/symmetric_eigen.hpp"

namespace farrier::estimation {
namespace {

constexpr double kLargestThreshold = 1e20;  // its square is within the range of covariances

}  // namespace

template <int N>
std::optional<Error> InformationFilter<N>::check(const char* method, const DirectionalParams& params,
                                                 const Parameters& theta0) {
  if (!(params.forgetting_factor > 0.0 && params.forgetting_factor <= 1.0)) {
    return Error{"forgetting_factor must be above 0 and at most 1, is " + std::to_string(params.forgetting_factor)};
  }
  if (const auto refused = check_covariance(N, params.initial_covariance, kLargest)) {
    return refused;
  }
  if (!(params.excitation_min >= 1.0 / kLargestThreshold && params.excitation_min <= kLargestThreshold)) {
    return Error{std::string(method) + ".excitation_min must be within 1e-20 and 1e20"};
  }
  if (!theta0.allFinite()) {
    return Error{"the first estimate must be finite"};
  }
  return std::nullopt;
}

template <int N>
InformationFilter<N>::InformationFilter(const DirectionalParams& params, const Parameters& theta0) noexcept
    : Regression<N>(theta0), params_(params), r_(Covariance::Identity() / params.initial_covariance) {}

template <int N>
typename InformationFilter<N>::Covariance InformationFilter<N>::covariance(int) const noexcept {
  const Covariance p = r_.llt().solve(Covariance::Identity());
  return 0.5 * (p + p.transpose());
}

template <int N>
double InformationFilter<N>::information_floor() const noexcept {
  const double epsilon = params_.excitation_min;
  return std::min(1.0 / params_.initial_covariance, epsilon * epsilon / (1.0 - params_.forgetting_factor));
}

template <int N>
RlsStatus InformationFilter<N>::absorb(const Covariance& remembered, const Regressor& h, const Eigen::Vector3d& e,
                                       double lambda) noexcept {
  const Covariance r = remembered + h * h.transpose();
  const Eigen::LLT<Covariance> factor(r);
  const Regressor gain = factor.solve(h);
  if (factor.info() != Eigen::Success || !gain.allFinite() || !(r.trace() <= kLargestSquare)) {
    r_ = Covariance::Identity() / params_.initial_covariance;
    return this->status_ = RlsStatus::kCovarianceNotPositiveDefinite;
  }
  if (!this->accept(this->theta_ + e * gain.transpose())) {
    return this->status_;
  }
  r_ = r;
  // The sample leaves the share 1 - h'R^-1 h of an error.
  this->account(e, Eigen::Vector3d::Constant(1.0 - h.dot(gain)), Eigen::Vector3d::Constant(lambda));
  return this->status_ = RlsStatus::kOk;
}

template <int N>
Result<VariableDirection<N>> VariableDirection<N>::create(const DirectionalParams& params, const Parameters& theta0) {
  if (const auto refused = VariableDirection::check("vdf", params, theta0)) {
    return *refused;
  }
  return VariableDirection(params, theta0);
}

template <int N>
RlsStatus VariableDirection<N>::update(const Regressor& h, const Eigen::Vector3d& y) noexcept {
  Eigen::Vector3d e;
  if (!this->innovation(h, y, e)) {
    return this->status_;
  }
  // R = U S U'; s_i <- lambda s_i where |u_i'h| > epsilon (Goel, Bruce, Bernstein 2020)
  const control::SymmetricEigen<N> eigen = control::symmetric_eigen<N>(this->r_);
  if (!eigen.converged) {
    this->r_ = Covariance::Identity() / this->params_.initial_covariance;
    return this->status_ = RlsStatus::kCovarianceNotPositiveDefinite;
  }
  const Regressor along = eigen.vectors.transpose() * h;
  const double lambda = this->params_.forgetting_factor;
  const double floor = this->information_floor();
  Covariance remembered = Covariance::Zero();
  bool limited = false;
  bool forgotten = false;
  for (int i = 0; i < N; ++i) {
    double s = std::max(eigen.values(i), floor);  // below it by rounding only
    if (std::abs(along(i)) > this->params_.excitation_min) {
      limited |= lambda * s < floor;
      s = std::max(lambda * s, floor);
      forgotten = true;
    }
    const Regressor u = eigen.vectors.col(i);
    remembered += s * (u * u.transpose());
  }
  this->limited_ = limited;
  return this->absorb(remembered, h, e, forgotten ? lambda : 1.0);
}

template <int N>
Result<SubspaceOfInformation<N>> SubspaceOfInformation<N>::create(const DirectionalParams& params,
                                                                  const Parameters& theta0) {
  if (const auto refused = SubspaceOfInformation::check("sift", params, theta0)) {
    return *refused;
  }
  return SubspaceOfInformation(params, theta0);
}

template <int N>
RlsStatus SubspaceOfInformation<N>::update(const Regressor& h, const Eigen::Vector3d& y) noexcept {
  Eigen::Vector3d e;
  if (!this->innovation(h, y, e)) {
    return this->status_;
  }
  if (!(h.norm() >= this->params_.excitation_min)) {
    return this->status_ = RlsStatus::kRegressorTooSmall;
  }
  // R <- R - (1 - lambda) R h (h'R h)^-1 h'R (Lai and Bernstein 2024)
  const Regressor rh = this->r_ * h;
  const double lambda = this->params_.forgetting_factor;
  const double known = h.dot(rh);
  const Covariance remembered = this->r_ - ((1.0 - lambda) / known) * (rh * rh.transpose());
  return this->absorb(remembered, h, e, lambda);
}

template <int N>
double SubspaceOfInformation<N>::information_ceiling(double beta) const noexcept {
  return std::max(1.0 / this->params_.initial_covariance, beta / (1.0 - this->params_.forgetting_factor));
}

template class InformationFilter<3>;
template class InformationFilter<4>;
template class InformationFilter<5>;
template class VariableDirection<3>;
template class VariableDirection<4>;
template class VariableDirection<5>;
template class SubspaceOfInformation<3>;
template class SubspaceOfInformation<4>;
template class SubspaceOfInformation<5>;

}  // namespace farrier::estimation
