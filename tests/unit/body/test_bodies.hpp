#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include "body/model/body_state.hpp"
#include "core/noise.hpp"

namespace farrier::body {

/// Uniform numbers in [-1, 1], the same in every run.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : stream_(seed, "body", "test") {}
  double next() { return 2.0 * stream_.uniform(count_++) - 1.0; }
  Eigen::Vector3d vector() {
    const double x = next(), y = next();
    return {x, y, next()};
  }
  Eigen::Vector3d direction() { return vector().normalized(); }

 private:
  NoiseStream stream_;
  Tick count_ = 0;
};

/// The tensor of eight equal masses at random places: possible, positive definite, with products.
inline RigidInertia random_inertia(Draws& draws, double mass_kg, double size_m) {
  constexpr int kMasses = 8;
  RigidInertia inertia{mass_kg, size_m * draws.vector(), Eigen::Matrix3d::Zero()};
  for (int i = 0; i < kMasses; ++i) {
    const Eigen::Vector3d at_m = size_m * draws.vector();
    inertia.tensor_kg_m2 +=
        mass_kg / kMasses * (at_m.squaredNorm() * Eigen::Matrix3d::Identity() - at_m * at_m.transpose());
  }
  return inertia;
}

/// A body whose axes, offsets and tensors are random: no symmetry hides a mistake.
inline BodyModel random_body(int legs, std::uint64_t seed) {
  Draws draws(seed);
  BodyModel model;
  model.trunk = random_inertia(draws, 40.0, 0.5);
  for (int number = 0; number < legs; ++number) {
    LegModel leg;
    leg.name = "leg" + std::to_string(number);
    for (Link& link : leg.links) {
      link.hinge_m = 0.4 * draws.vector();
      link.axis = draws.direction();
      link.armature_kg_m2 = 0.005 * (1.0 + draws.next());
      link.inertia = random_inertia(draws, 2.0 + draws.next(), 0.2);
    }
    leg.foot_m = 0.4 * draws.vector();
    leg.foot_radius_m = 0.02;
    model.legs.push_back(leg);
  }
  return model;
}

/// Any attitude; angles in [-3, 3] rad, speeds up to 2 m/s, 3 rad/s of the trunk and 10 rad/s of the joints.
inline BodyState random_state(int joints, Draws& draws) {
  BodyState state = BodyState::zero(joints);
  state.position_m = 2.0 * draws.vector();
  const Eigen::Vector3d imaginary = draws.vector();
  state.attitude = Eigen::Quaterniond(draws.next(), imaginary.x(), imaginary.y(), imaginary.z()).normalized();
  state.linear_velocity_m_s = 2.0 * draws.vector();
  state.angular_velocity_rad_s = 3.0 * draws.vector();
  for (int joint = 0; joint < joints; ++joint) {
    state.angles_rad[joint] = 3.0 * draws.next();
    state.velocities_rad_s[joint] = 10.0 * draws.next();
  }
  return state;
}

/// `state` after `time_s` at its present velocities.
inline BodyState moved(const BodyState& state, double time_s) {
  BodyState later = state;
  later.position_m += time_s * state.linear_velocity_m_s;
  const double angle_rad = time_s * state.angular_velocity_rad_s.norm();
  if (angle_rad != 0.0) {
    later.attitude = state.attitude * Eigen::Quaterniond(Eigen::AngleAxisd(
                                          angle_rad, time_s * state.angular_velocity_rad_s / angle_rad));
  }
  later.angles_rad += time_s * state.velocities_rad_s;
  return later;
}

}  // namespace farrier::body
