#include "locomotion/guards/joint_guard.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::locomotion {
namespace {

// Time constant of the means: a force loop that swings about its command with 50 Hz and more follows it.
constexpr double kMean_s = 0.010;

}  // namespace

JointGuard::JointGuard(const JointGuardParams& params, const Eigen::Vector3d& torque_limits_Nm, int legs,
                       double period_s) noexcept
    : params_(params),
      most_error_Nm_(Eigen::Vector3d(params.haa_torque_share, params.torque_share, params.torque_share)
                         .cwiseProduct(torque_limits_Nm)),
      legs_(legs),
      period_s_(period_s),
      share_(std::min(1.0, period_s / kMean_s)) {
  before_Nm_.fill(Eigen::Vector3d::Zero());
  off_s_.fill(Eigen::Vector3d::Zero());
  mean_error_Nm_ = off_s_;
  mean_velocity_rad_s_ = off_s_;
}

// x <- x + (T / tau) (u - x), where u is a number
double JointGuard::averaged(double& mean, double value) const noexcept {
  mean += std::isfinite(value) ? share_ * (value - mean) : -mean;
  return mean;
}

void JointGuard::step(const Readings& readings, const LegTorques& asked_Nm, JointDuty duty) noexcept {
  const double dead_after_s = duty == JointDuty::kWalk ? params_.dead_after_s : params_.dead_standing_after_s;
  for (int leg = 0; leg < legs_; ++leg) {
    const LegReadings& is = readings.legs[leg];
    for (int joint = 0; joint < kJointsPerLeg; ++joint) {
      const double commanded_Nm = before_Nm_[leg][joint];
      const double error_Nm = averaged(mean_error_Nm_[leg][joint], is.torque_Nm[joint] - commanded_Nm);
      const double velocity_rad_s = averaged(mean_velocity_rad_s_[leg][joint], is.velocity_rad_s[joint]);
      const bool off = std::abs(error_Nm) > most_error_Nm_[joint];
      const bool still = std::abs(velocity_rad_s) < params_.still_rad_s;
      double& off_s = off_s_[leg][joint];
      if (duty == JointDuty::kNone) {
        off_s = 0.0;
      } else if (still && off) {
        off_s += period_s_;
      } else if (!still || std::abs(commanded_Nm) > most_error_Nm_[joint]) {
        off_s = std::max(0.0, off_s - period_s_);
      }
      if (!dead_ && off_s > dead_after_s) {
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
