#pragma once

#include <nlopt.h>

#include <Eigen/Core>
#include <array>
#include <memory>

#include "locomotion/force_distribution.hpp"

namespace farrier::bench {

/// The problem of locomotion::ForceDistribution on level ground, by NLopt's SLSQP (Kraft 1994): each force by its three
/// components, pyramids as linear inequalities, limits as bounds.
class SlsqpForces {
 public:
  explicit SlsqpForces(const locomotion::ForceDistributionParams& params);

  /// As ForceDistribution::distribute(); every normal must be vertical. Returns false if SLSQP fails.
  bool distribute(const locomotion::Wrench& wanted, const locomotion::PerLeg<locomotion::Contact>& contacts, int count,
                  locomotion::PerLeg<Eigen::Vector3d>& forces_N);

 private:
  static constexpr int kUnknowns = 3 * locomotion::kMaxLegs;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kUnknowns, 1>;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kUnknowns, kUnknowns>;
  struct Delete {
    void operator()(nlopt_opt optimiser) const noexcept { nlopt_destroy(optimiser); }
  };
  /// friction * normal -+ tangent >= 0 of one foot.
  struct Side {
    int tangent, normal;
    double sign, friction;
  };

  static double cost(unsigned n, const double* x, double* gradient, void* self);
  static double beyond(unsigned n, const double* x, double* gradient, void* side);
  nlopt_opt optimiser_of(int count);

  locomotion::ForceDistributionParams params_;
  std::array<std::unique_ptr<nlopt_opt_s, Delete>, locomotion::kMaxLegs + 1> optimisers_;
  std::array<Side, 4 * locomotion::kMaxLegs> sides_{};
  Matrix hessian_;  // cost: x' H x / 2 - g' x
  Vector gradient_;
};

}  // namespace farrier::bench
