#pragma once

#include <optional>

#include "locomotion/controller.hpp"

namespace farrier::locomotion {

/// Limits from which a joint counts as dead.
struct JointGuardParams {
  double torque_share = 0.14;      ///< of the joint's torque limit: a joint whose torque is off by less follows, 0..1
  double haa_torque_share = 0.28;  ///< the same of HAA, which is still in much of a trot; 0..1
  double still_rad_s = 0.06;       ///< a joint that moves faster in the mean is weak and not dead, > 0
  double dead_after_s = 0.045;     ///< ticks that are off and still, less those that follow, so long; >= 0
  double dead_standing_after_s = 1.0;  ///< the same on four feet, where no fall is near; >= 0
};

/// Duty of the joints. They need not follow while the robot lies, before they are armed, and after a fall.
enum class JointDuty { kNone, kStand, kWalk };

/// A joint of a leg.
struct LegJoint {
  int leg = 0;
  int index = 0;  ///< 0 HAA, 1 HFE, 2 KFE

  friend bool operator==(const LegJoint&, const LegJoint&) = default;
};

/// Finds a joint that does not follow: it stays where it is, and its mean torque is not the one that it was asked for. A
/// valve that is stuck holds its oil. A weak valve moves the joint, though too slowly. A joint follows if it moves, or if
/// it is asked for much and has it. One that is still and asked for little proves neither.
///
/// The alarm stays until the robot lies and is asked to lie.
class JointGuard {
 public:
  /// `torque_limits_Nm`: of HAA, HFE and KFE.
  JointGuard(const JointGuardParams& params, const Eigen::Vector3d& torque_limits_Nm, int legs,
             double period_s) noexcept;

  /// Takes the readings of a tick. `asked_Nm` are the torques commanded in the tick before.
  void step(const Readings& readings, const LegTorques& asked_Nm, JointDuty duty) noexcept;

  /// The command that acts: with an alarm the robot lies down at once. `lies`: the robot lies.
  MotionCommand command(const MotionCommand& asked, bool lies) noexcept;

  /// The joint of the alarm; none without one.
  const std::optional<LegJoint>& dead() const noexcept { return dead_; }

 private:
  double averaged(double& mean, double value) const noexcept;

  JointGuardParams params_;
  Eigen::Vector3d most_error_Nm_;
  int legs_;
  double period_s_;
  double share_;          // of a new error in the mean
  LegTorques before_Nm_;  // commanded two ticks ago: a torque acts one tick after its command, and is read at the next
  PerLeg<Eigen::Vector3d> mean_error_Nm_, mean_velocity_rad_s_;
  PerLeg<Eigen::Vector3d> off_s_;
  std::optional<LegJoint> dead_;
};

}  // namespace farrier::locomotion
