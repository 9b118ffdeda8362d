#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

namespace farrier::locomotion {

inline constexpr int kMaxLegs = 6;
inline constexpr int kJointsPerLeg = 3;

/// A value per leg, in the robot's order. Entries beyond the robot's number of legs are unused.
template <class T>
using PerLeg = std::array<T, kMaxLegs>;

/// The same value for every leg.
template <class T>
constexpr PerLeg<T> for_every_leg(const T& value) {
  return [&]<std::size_t... kLeg>(std::index_sequence<kLeg...>) {
    return PerLeg<T>{(static_cast<void>(kLeg), value)...};
  }
  (std::make_index_sequence<kMaxLegs>{});
}

/// |det J| in m^3 below which a leg counts as straight, and its Jacobian is not inverted. HyQ's standing leg has 0.04.
inline constexpr double kSingularLeg_m3 = 1e-3;

/// Readings of the three joints of a leg, in the order HAA, HFE, KFE.
struct LegReadings {
  Eigen::Vector3d position_rad = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_rad_s = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque_Nm = Eigen::Vector3d::Zero();  ///< of the actuators, positive along +position
};

/// Motion of the trunk that the legs feel. Both vectors are in the trunk frame: x forward, y left, z up.
struct TrunkMotion {
  Eigen::Vector3d gravity_m_s2 = Eigen::Vector3d::Zero();  ///< (0, 0, -9.81) for an upright trunk
  Eigen::Vector3d angular_velocity_rad_s = Eigen::Vector3d::Zero();
};

/// Kinematics and dynamics of one leg. Vectors are in the trunk frame, with the trunk held still.
/// The leg obeys M q'' + h = tau + J^T f, where f is the force of the ground on the foot.
struct LegState {
  Eigen::Vector3d foot_m = Eigen::Vector3d::Zero();  ///< s, centre of the foot sphere from the trunk's origin
  Eigen::Vector3d foot_velocity_m_s = Eigen::Vector3d::Zero();  ///< J q'
  Eigen::Vector3d shank_rate_rad_s =
      Eigen::Vector3d::Zero();                             ///< angular velocity of the last link relative to the trunk
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Identity();  ///< J = ds/dq, m/rad
  Eigen::Vector3d foot_bias_m_s2 = Eigen::Vector3d::Zero();     ///< J' q'
  Eigen::Matrix3d inertia_kg_m2 = Eigen::Matrix3d::Identity();  ///< M, of the leg's three joints
  Eigen::Vector3d bias_torque_Nm = Eigen::Vector3d::Zero();     ///< h, gravity, velocity terms, joint friction
};

/// All legs of the robot at one tick, and its mass distribution.
struct BodyState {
  PerLeg<LegState> legs;
  Eigen::Vector3d com_m = Eigen::Vector3d::Zero();  ///< centre of mass of the whole robot, trunk frame
};

/// The rigid bodies of a robot, as locomotion needs them. robot::LocomotionModel implements it by lib/body.
class BodyModel {
 public:
  virtual ~BodyModel() = default;

  /// Number of legs, 1..kMaxLegs. Constant.
  virtual int leg_count() const noexcept = 0;

  /// Nominal mass of the whole robot, kg, > 0. Constant.
  virtual double mass_kg() const noexcept = 0;

  /// Computes the state of the body from readings of leg_count() legs. Allocates nothing.
  virtual void update(std::span<const LegReadings> legs, const TrunkMotion& trunk, BodyState& state) const noexcept = 0;
};

}  // namespace farrier::locomotion
