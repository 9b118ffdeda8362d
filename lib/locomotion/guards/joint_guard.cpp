#include "locomotion/guards/joint_guard.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::locomotion {

JointGuard::JointGuard(const JointGuardParams& params, const Eigen::Vector3d& torque_limits_Nm, int legs,
                       double period_s) noexcept
    : params_(params), most_error_Nm_(params.torque_share * torque_limits_Nm), legs_(legs), period_s_(period_s) {
  before_Nm_.fill(Eigen::Vector3d::Zero());
  off_s_.fill(Eigen::Vector3d::Zero());
}

void JointGuard::step(const Readings& readings, const LegTorques& asked_Nm, bool acts) noexcept {
  for (int leg = 0; leg < legs_; ++leg) {
    const LegReadings& is = readings.legs[leg];
    for (int joint = 0; joint < kJointsPerLeg; ++joint) {
      const double error_Nm = std::abs(is.torque_Nm[joint] - before_Nm_[leg][joint]);
      const bool off = acts && error_Nm > most_error_Nm_[joint] &&
                       std::abs(is.velocity_rad_s[joint]) < params_.still_rad_s;  // false for NaN
      double& off_s = off_s_[leg][joint];
      off_s = acts ? std::max(0.0, off_s + (off ? period_s_ : -period_s_)) : 0.0;
      if (!dead_ && off_s > params_.dead_after_s) {
        dead_ = LegJoint{leg, joint};
      }
    }
  }
  before_Nm_ = asked_Nm;
}

MotionCommand JointGuard::command(const MotionCommand& asked, bool lies) noexcept {
  if (dead_ && lies && asked.request == Request::kLie) {
    dead_.reset();
  }
  return dead_ ? MotionCommand{.request = Request::kLie, .height_m = asked.height_m, .at_once = true, .feet_down = true}
               : asked;
}

}  // namespace farrier::locomotion
