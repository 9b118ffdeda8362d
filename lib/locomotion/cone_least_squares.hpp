#pragma once

#include <Eigen/Core>
#include <array>

#include "locomotion/body_model.hpp"

namespace farrier::locomotion {

inline constexpr int kEdgesPerCone = 4;
inline constexpr int kMaxEdges = kEdgesPerCone * kMaxLegs;
/// Independent edges that can be positive at once. A force has three components, so three edges of a cone suffice.
inline constexpr int kMaxPassive = 3 * kMaxLegs;

using EdgeVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxEdges, 1>;
using EdgeMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxEdges, kMaxEdges>;

/// Minimise x^T H x / 2 - g^T x over x >= 0, where the four entries of cone i sum to at most limit_i.
struct ConeProblem {
  EdgeMatrix hessian;    ///< H, 4 n x 4 n, positive definite on any three edges of each cone
  EdgeVector gradient;   ///< g, 4 n
  int cones = 0;         ///< n, 0..kMaxLegs
  PerLeg<double> limit;  ///< > 0; infinity for none
};

struct ConeSolution {
  EdgeVector x;                ///< 4 n
  PerLeg<double> limit_force;  ///< multiplier of each limit, >= 0, 0 if the limit is not reached
  int iterations = 0;          ///< linear solves
  bool converged = false;      ///< false if kMaxConeIterations ended the search; x is feasible then too
};

inline constexpr int kMaxConeIterations = 100;

/// Nonnegative least squares by an active set (Lawson and Hanson 1974, ch. 23, algorithm NNLS), on normal equations, with
/// one additional bound per cone on the sum of its entries. A reached bound is an equality of the inner solve; it is
/// released when its multiplier becomes negative. The objective falls in every outer iteration, so the search is finite.
/// Allocates nothing.
class ConeLeastSquares {
 public:
  const ConeSolution& solve(const ConeProblem& problem) noexcept;

 private:
  using Passive = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxPassive, 1>;

  bool add_most_wanted() noexcept;
  void descend() noexcept;
  Passive solve_with_active_limits() noexcept;
  double step_to_boundary(const Passive& target, int& edge, int& cone) const noexcept;
  void multipliers() noexcept;
  double sum_of(int cone) const noexcept { return solution_.x.segment<kEdgesPerCone>(kEdgesPerCone * cone).sum(); }
  int passive_edges_of(int cone) const noexcept;
  void remove(int position) noexcept;

  const ConeProblem* problem_ = nullptr;
  ConeSolution solution_;
  EdgeVector slope_;                        // g - H x
  std::array<int, kMaxPassive> passive_{};  // edges that may be positive
  int count_ = 0;
  std::array<bool, kMaxLegs> limited_{};  // cones whose bound is an equality
  double tolerance_ = 0.0;
};

}  // namespace farrier::locomotion
