#include "locomotion/trunk_reference.hpp"

#include <algorithm>

#include "locomotion/rotation.hpp"

namespace farrier::locomotion {
namespace {

// Factor on accelerations and on the speed downwards of a command that acts at once.
constexpr double kAtOnce = 2.0;

// `from` moved towards `to` by at most `most`; a command that is not a number counts as zero
double towards(double from, double to, double limit, double most) noexcept {
  const double clamped = to == to ? std::clamp(to, -limit, limit) : 0.0;
  return from + std::clamp(clamped - from, -most, most);
}

}  // namespace

void TrunkReference::reset(const TrunkState& trunk, double height_m) noexcept {
  velocity_.setZero();
  yaw_rate_ = 0.0;
  height_m_ = height_m;
  heading_ = heading_of(trunk.rotation);
  wanted_ = {.position_m = trunk.position_m, .rotation = heading_};
}

double TrunkReference::commanded_height_m(const MotionCommand& command) const noexcept {
  return command.height_m > 0.0 ? std::clamp(command.height_m, params_.least_height_m, params_.largest_height_m)
                                : params_.default_height_m;
}

void TrunkReference::ramp(const MotionCommand& command, bool moving) noexcept {
  const double change = (command.at_once ? kAtOnce : 1.0) * params_.acceleration_m_s2 * period_s_;
  velocity_.x() = towards(velocity_.x(), moving ? command.forward_m_s : 0.0, params_.fastest_forward_m_s, change);
  velocity_.y() = towards(velocity_.y(), moving ? command.left_m_s : 0.0, params_.fastest_left_m_s, change);
  yaw_rate_ = towards(yaw_rate_, moving ? command.yaw_rate_rad_s : 0.0, params_.fastest_yaw_rad_s,
                      params_.yaw_acceleration_rad_s2 * period_s_);
}

// Integrates the heading, and pulls it along where the trunk stays behind.
void TrunkReference::turn(const Eigen::Matrix3d& heading) noexcept {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  heading_ = orthonormalised(heading_ * rotation_by(period_s_ * yaw_rate_ * up));
  const double ahead = sine_vector(heading_ * heading.transpose()).z();
  if (std::max(ahead, -ahead) > params_.yaw_slack_rad) {
    heading_ = heading * rotation_by(std::clamp(ahead, -params_.yaw_slack_rad, params_.yaw_slack_rad) * up);
  }
}

void TrunkReference::step(const MotionCommand& command, bool moving, double height_m, const TrunkState& trunk,
                          const GroundPlane& ground) noexcept {
  ramp(command, moving);
  turn(heading_of(trunk.rotation));
  const double rise_m = params_.height_speed_m_s * period_s_;
  height_m_ += std::clamp(height_m - height_m_, command.at_once ? -kAtOnce * rise_m : -rise_m, rise_m);
  wanted_.velocity_m_s = heading_ * Eigen::Vector3d{velocity_.x(), velocity_.y(), 0.0};
  wanted_.angular_velocity_rad_s = {0.0, 0.0, yaw_rate_};
  wanted_.position_m += period_s_ * wanted_.velocity_m_s;
  const Eigen::Vector3d slack = Eigen::Vector3d::Constant(params_.position_slack_m);
  const Eigen::Vector3d ahead = (wanted_.position_m - trunk.position_m).cwiseMax(-slack).cwiseMin(slack);
  wanted_.position_m = trunk.position_m + ahead;
  wanted_.position_m.z() = ground.height_at(trunk.position_m) + height_m_;
  const Eigen::Vector3d up =
      ((1.0 - params_.tilt_share) * Eigen::Vector3d::UnitZ() + params_.tilt_share * ground.normal()).normalized();
  wanted_.rotation = tilt_to(up) * heading_;
}

}  // namespace farrier::locomotion
