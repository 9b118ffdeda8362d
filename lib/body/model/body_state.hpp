#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "body/model/body_model.hpp"

namespace farrier::body {

inline constexpr int kTrunkVelocities = 6;
inline constexpr int kMaxVelocities = kTrunkVelocities + kMaxJoints;

// Vectors and matrices whose size is set by the number of legs. They live on the stack.

/// One entry per joint: leg by leg, from the trunk outwards.
using JointVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxJoints, 1>;
/// Generalised velocity or force, n = 6 + joints entries, in the order of BodyState.
using VelocityVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxVelocities, 1>;
/// n x n.
using MassMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxVelocities, kMaxVelocities>;
/// 3 x n.
using FootJacobian = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, kMaxVelocities>;

/// Pose and velocity of the whole robot. The generalised velocity v = (linear, angular, joints) is that of MuJoCo's free
/// joint: the linear velocity is in the world's axes, the angular velocity in the trunk's. A generalised force is its
/// dual: a force in the world's axes, a moment about the trunk's origin in the trunk's axes, and joint torques.
struct BodyState {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();              ///< of the trunk's origin, in the world
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();      ///< from the trunk's axes to the world's; unit
  JointVector angles_rad;                                            ///< in [-8, 8]
  Eigen::Vector3d linear_velocity_m_s = Eigen::Vector3d::Zero();     ///< of the trunk's origin, world's axes
  Eigen::Vector3d angular_velocity_rad_s = Eigen::Vector3d::Zero();  ///< trunk's axes
  JointVector velocities_rad_s;

  /// At rest in the world's origin with all joint angles zero.
  static BodyState zero(int joints) {
    BodyState state;
    state.angles_rad = JointVector::Zero(joints);
    state.velocities_rad_s = JointVector::Zero(joints);
    return state;
  }

  VelocityVector velocity() const noexcept {
    VelocityVector v(kTrunkVelocities + velocities_rad_s.size());
    v << linear_velocity_m_s, angular_velocity_rad_s, velocities_rad_s;
    return v;
  }
};

}  // namespace farrier::body
