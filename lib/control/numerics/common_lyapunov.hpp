#pragma once

#include <array>
#include <span>

#include <Eigen/Core>

namespace farrier::control::switching {

// Smaller systems are padded with states that vanish in a tick.
inline constexpr int kStates = 6;
using Matrix6 = Eigen::Matrix<double, kStates, kStates>;

inline constexpr int kMaxNewtonSteps = 60;
inline constexpr std::size_t kMaxLoops = 4;

/// sum_k (a')^k q a^k by Smith's doubling (1968); not finite when it does not converge.
Matrix6 lyapunov(const Matrix6& a, const Matrix6& q) noexcept;

/// Largest eigenvalue of m'p m over `over`, both of which are symmetric and `over` positive definite; infinite when it
/// is not.
double largest_ratio(const Matrix6& m, const Matrix6& p, const Matrix6& over) noexcept;

/// True if p > 0 and m'p m < p for every loop, by Cholesky, with a margin of 1e-10 of p for rounding.
bool is_common(const Matrix6& p, std::span<const Matrix6> loops) noexcept;

/// Finds a p with is_common(p, loops), or returns false. Up to kMaxLoops loops.
bool find_common(std::span<const Matrix6> loops, Matrix6& p) noexcept;

}  // namespace farrier::control::switching
