#pragma once

#include <Eigen/Core>
#include <limits>

#include "locomotion/body_model.hpp"
#include "locomotion/cone_least_squares.hpp"

namespace farrier::locomotion {

using Wrench = Eigen::Matrix<double, 6, 1>;  ///< force (N), then moment (Nm)

/// Weights of the force distribution. The defaults track the moment about roll and pitch three times as well as force.
/// They were found by trotting a simulated HyQ; MIT's balance controller has S = (1, 1, 10, 20, 10, 10).
struct ForceDistributionParams {
  Wrench weight = (Wrench() << 1.0, 1.0, 3.0, 3.0, 3.0, 1.5).finished();  ///< diagonal of S, 1/N and 1/(N m)
  double force_weight = 2.5e-3;  ///< alpha, > 0: cost of forces, relative to the wrench's
  double least_N = 20.0;         ///< normal force that every foot on the ground keeps, >= 0, to stay there
  double friction = 0.5;         ///< mu, > 0. Edges of the pyramid reach sqrt(2) mu
};

/// A foot on the ground.
struct Contact {
  Eigen::Vector3d lever_m;                                   ///< r, foot from the centre of mass, world frame
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();         ///< unit vector, away from the ground
  double limit_N = std::numeric_limits<double>::infinity();  ///< upper limit of the normal force, > 0
};

/// Distributes a wrench at the centre of mass over the feet on the ground:
///   f = argmin |S (A f - b)|^2 + alpha |f|^2,   A = [I .. I; [r_1]x .. [r_n]x]   (Focchi 2016, eqs. (4), (5);
///   Di Carlo 2018 and MIT's BalanceController use the same cost)
/// over the friction pyramids |f_t1|, |f_t2| <= mu f_n and least <= f_n <= limit. Each force is a sum of the four edges of
/// its pyramid with factors >= 0, which leaves a least squares problem in nonnegative unknowns.
class ForceDistribution {
 public:
  explicit ForceDistribution(const ForceDistributionParams& params) noexcept : params_(params) {}

  /// Computes the forces of the ground on the feet, N, world frame. `count` contacts, 0..kMaxLegs. Allocates nothing.
  void distribute(const Wrench& wanted, const PerLeg<Contact>& contacts, int count,
                  PerLeg<Eigen::Vector3d>& forces_N) noexcept;

  /// Linear solves of the last call, and the number of calls that the bound on them ended.
  int iterations() const noexcept { return iterations_; }
  int unconverged() const noexcept { return unconverged_; }

 private:
  ForceDistributionParams params_;
  ConeProblem problem_;
  ConeLeastSquares solver_;
  int iterations_ = 0;
  int unconverged_ = 0;
};

}  // namespace farrier::locomotion
