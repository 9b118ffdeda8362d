#pragma once

#include <Eigen/Core>

#include <type_traits>

#include "core/result.hpp"

namespace farrier::control {

/// Outcome of solving a Riccati equation; a refused Result never carries kSolved.
enum class RiccatiStatus {
  kSolved,
  kNotFinite,           ///< an entry of the problem is not finite
  kWeightsNotDefinite,  ///< not R > 0 and Q - N R^-1 N' >= 0, both symmetric (8.5)
  kNotStabilisable,     ///< a mode that does not decay cannot be reached by the input
  kNotConverged,        ///< the bound on the iterations was hit, or rounding left too large a residual
  kClosedLoopUnstable,  ///< a solution, but not the stabilising one (a non-decaying mode carries no weight)
};

const char* to_string(RiccatiStatus status) noexcept;

/// R: positive, of M inputs; a number for one input.
template <int M>
using InputWeight = std::conditional_t<M == 1, double, Eigen::Matrix<double, M, M>>;

/// Solution of (7.4) for N states and M inputs.
template <int N, int M = 1>
struct RiccatiSolution {
  Eigen::Matrix<double, N, N> s;  ///< Riccati matrix, symmetric, positive semi-definite
  Eigen::Matrix<double, M, N> k;  ///< gain of u = -k x: (B'SB + R)^-1 (B'SA + N'), (7.5) corrected
  int iterations;                 ///< of the algorithm that was used
  double relative_residual;       ///< Frobenius norm of the left side of (7.4) over that of S
  double radius_bound;            ///< not below the spectral radius of A - B k; below one
};

/// Left side of (7.4): A'SA - S - (A'SB + N)(B'SB + R)^-1 (B'SA + N') + Q. Zero for a solution.
template <int N, int M>
Eigen::Matrix<double, N, N> riccati_residual(const Eigen::Matrix<double, N, N>& a, const Eigen::Matrix<double, N, M>& b,
                                             const Eigen::Matrix<double, N, N>& q, const InputWeight<M>& r,
                                             const Eigen::Matrix<double, N, M>& n,
                                             const Eigen::Matrix<double, N, N>& s) noexcept;

/// The same for one input.
template <int N>
Eigen::Matrix<double, N, N> riccati_residual(const Eigen::Matrix<double, N, N>& a, const Eigen::Matrix<double, N, 1>& b,
                                             const Eigen::Matrix<double, N, N>& q, double r,
                                             const Eigen::Matrix<double, N, 1>& n,
                                             const Eigen::Matrix<double, N, N>& s) noexcept {
  return riccati_residual<N, 1>(a, b, q, r, n, s);
}

/// Stabilising solution of the discrete-time algebraic Riccati equation (7.4) by the structured doubling algorithm
/// (Anderson 1978; Chu, Fan, Lin and Wang 2004, "Structure-preserving algorithms for periodic discrete-time algebraic
/// Riccati equations", eq. 2.6). Step k stands for 2^k steps of (8.1), so convergence is quadratic. At most 40
/// doublings and two Newton corrections (Hewer 1971). Units are the caller's; normalise first. Refuses by name. For
/// loops: N = 3..6 with one input, which allocates nothing. For analysis, with lib/textbook linked: N = 2 with one
/// input. Also for analysis: N and M both Eigen::Dynamic, any number of states and inputs, on the heap; mismatched
/// sizes are a bug.
template <int N, int M>
Result<RiccatiSolution<N, M>, RiccatiStatus> solve_dare(const Eigen::Matrix<double, N, N>& a,
                                                        const Eigen::Matrix<double, N, M>& b,
                                                        const Eigen::Matrix<double, N, N>& q, const InputWeight<M>& r,
                                                        const Eigen::Matrix<double, N, M>& n) noexcept;

/// The same for one input.
template <int N>
Result<RiccatiSolution<N>, RiccatiStatus> solve_dare(const Eigen::Matrix<double, N, N>& a,
                                                     const Eigen::Matrix<double, N, 1>& b,
                                                     const Eigen::Matrix<double, N, N>& q, double r,
                                                     const Eigen::Matrix<double, N, 1>& n) noexcept {
  return solve_dare<N, 1>(a, b, q, r, n);
}

/// The thesis's solver: (8.1) from (8.2) until the step of S, which is the residual, falls to relative_tolerance of S
/// (the thesis uses an absolute 0.4 on its square), or max_iterations. Linear convergence with the square of the closed
/// loop's spectral radius. It is the check and the baseline of solve_dare, for N = 2..6 in lib/textbook.
template <int N>
Result<RiccatiSolution<N>, RiccatiStatus> solve_dare_by_iteration(
    const Eigen::Matrix<double, N, N>& a, const Eigen::Matrix<double, N, 1>& b, const Eigen::Matrix<double, N, N>& q,
    double r, const Eigen::Matrix<double, N, 1>& n, int max_iterations, double relative_tolerance) noexcept;

}  // namespace farrier::control
