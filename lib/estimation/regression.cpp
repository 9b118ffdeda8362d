#include "estimation/regression.hpp"

#include <string>

namespace farrier::estimation {

const char* to_string(RlsStatus status) noexcept {
  switch (status) {
    case RlsStatus::kNotYetSet: return "not yet set";
    case RlsStatus::kOk: return "ok";
    case RlsStatus::kRegressorTooSmall: return "regressor too small";
    case RlsStatus::kCovarianceNotPositiveDefinite: return "covariance not positive definite";
    case RlsStatus::kNotFinite: return "not finite";
  }
  return "unknown status";
}

std::optional<Error> check_covariance(int columns, double initial, double limit) {
  if (!(initial >= 1.0 / kLargest && initial <= kLargest)) {
    return Error{"initial_covariance must be within 1e-40 and 1e40"};
  }
  if (!(limit >= columns * initial && limit <= kLargest)) {
    return Error{"covariance_limit must be at least initial_covariance times the " + std::to_string(columns) +
                 " regressors, and at most 1e40"};
  }
  return std::nullopt;
}

}  // namespace farrier::estimation
