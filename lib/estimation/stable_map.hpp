#pragma once

#include <Eigen/Core>

#include <cstdint>

namespace farrier::estimation {

/// Outcome of map_to_stable: Hubacher (2014), Table F.1, "Estimator Base Class", in its order and with its numbers.
enum class StabilityStatus : std::uint8_t {
  kNotYetSet = 1,
  kStable = 2,           ///< every eigenvalue within the limit; nothing was changed
  kMappedToStable = 3,   ///< eigenvalues beyond the limit were put on it
  kEigenvalueError = 4,  ///< not finite, or too close to a matrix without a full set of eigenvectors; unchanged
};

const char* to_string(StabilityStatus status) noexcept;

/// Maps an estimated discrete-time system matrix to a stable one, Hubacher (2014), 8.1.1: A = V diag(z) V^-1, each |z|
/// > limit scaled to z limit / |z|, eigenvectors kept. A stays real. The result has no eigenvalue beyond limit + 1e-9.
/// N = 2, 3; limit in (0, 1).
template <int N>
StabilityStatus map_to_stable(Eigen::Matrix<double, N, N>& a, double limit) noexcept;

}  // namespace farrier::estimation
