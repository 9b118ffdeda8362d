#include "bench/slsqp_forces.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace farrier::bench {
namespace {

constexpr double kCostTolerance = 1e-10;// of the cost, relative
constexpr double kViolation_N = 1e-6;    // of a pyramid
constexpr int kMostEvaluations = 500;

}  // namespace

SlsqpForces::SlsqpForces(const locomotion::ForceDistributionParams& params) : params_(params) {
  for (int foot = 0; foot < locomotion::kMaxLegs; ++foot) {
    for (int side = 0; side < 4; ++side) {
      sides_[4 * foot + side] = {3 * foot + side / 2, 3 * foot + 2, side % 2 == 0 ? 1.0 : -1.0, params.friction};
    }
  }
}

double SlsqpForces::cost(unsigned n, const double* x, double* gradient, void* self) {
  const auto& of = *static_cast<const SlsqpForces*>(self);
  const Eigen::Map<const Eigen::VectorXd> forces(x, n);
  const Vector slope = of.hessian_ * forces;
  if (gradient != nullptr) {
    Eigen::Map<Eigen::VectorXd>(gradient, n) = slope - of.gradient_;
  }
  return 0.5 * forces.dot(slope) - of.gradient_.dot(forces);
}

double SlsqpForces::beyond(unsigned n, const double* x, double* gradient, void* side) {
  const auto& of = *static_cast<const Side*>(side);
  if (gradient != nullptr) {
    std::fill(gradient, gradient + n, 0.0);
    gradient[of.tangent] = of.sign;
    gradient[of.normal] = -of.friction;
  }
  return of.sign * x[of.tangent] - of.friction * x[of.normal];
}

nlopt_opt SlsqpForces::optimiser_of(int count) {
  auto& optimiser = optimisers_[count];
  if (optimiser == nullptr) {
    optimiser.reset(nlopt_create(NLOPT_LD_SLSQP, 3 * count));
    nlopt_set_min_objective(optimiser.get(), &cost, this);
    nlopt_set_ftol_rel(optimiser.get(), kCostTolerance);
    nlopt_set_maxeval(optimiser.get(), kMostEvaluations);
    for (int side = 0; side < 4 * count; ++side) {
      nlopt_add_inequality_constraint(optimiser.get(), &beyond, &sides_[side], kViolation_N);
    }
  }
  return optimiser.get();
}

// Unknowns are the forces beyond the least ones.
bool SlsqpForces::distribute(const locomotion::Wrench& wanted, const locomotion::PerLeg<locomotion::Contact>& contacts,
                             int count, locomotion::PerLeg<Eigen::Vector3d>& forces_N) {
  Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kUnknowns> weighted(6, 3 * count);
  locomotion::Wrench rest = wanted;
  Vector least = Vector::Constant(3 * count, -HUGE_VAL);
  Vector most = Vector::Constant(3 * count, HUGE_VAL);
  for (int i = 0; i < count; ++i) {
    const double least_N = std::min(params_.least_N, 0.5 * contacts[i].limit_N);
    forces_N[i] = least_N * contacts[i].normal;
    rest.head<3>() -= forces_N[i];
    rest.tail<3>() -= contacts[i].lever_m.cross(forces_N[i]);
    least[3 * i + 2] = 0.0;
    most[3 * i + 2] = contacts[i].limit_N - least_N;
    for (int axis = 0; axis < 3; ++axis) {
      weighted.col(3 * i + axis) << Eigen::Vector3d::Unit(axis), contacts[i].lever_m.cross(Eigen::Vector3d::Unit(axis));
    }
  }
  weighted = params_.weight.asDiagonal() * weighted;
  hessian_ = weighted.transpose() * weighted;
  hessian_.diagonal().array() += params_.force_weight;
  gradient_ = weighted.transpose() * params_.weight.cwiseProduct(rest);
  nlopt_opt optimiser = optimiser_of(count);
  nlopt_set_lower_bounds(optimiser, least.data());
  nlopt_set_upper_bounds(optimiser, most.data());
  Vector forces = Vector::Zero(3 * count);
  for (int i = 0; i < count; ++i) {
    forces[3 * i + 2] = std::clamp(wanted[2] / count, 0.0, most[3 * i + 2]);
  }
  double least_cost = 0.0;
  const nlopt_result result = nlopt_optimize(optimiser, forces.data(), &least_cost);
  for (int i = 0; i < count; ++i) {
    forces_N[i] += forces.segment<3>(3 * i);
  }
  return result > 0;
}

}  // namespace farrier::bench
