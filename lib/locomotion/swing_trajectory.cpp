#include "locomotion/swing_trajectory.hpp"

#include <algorithm>

#include "gait/smooth_step.hpp"

namespace farrier::locomotion {

gait::PointMotion SwingTrajectory::at(double progress, double swing_s,
                                      const Eigen::Vector3d& foothold_m) const noexcept {
  const double rate = 1.0 / swing_s;
  const double forward_rate = rate / params_.forward_share;
  const gait::Smooth along = gait::smooth_step(progress / params_.forward_share);
  const Eigen::Vector3d way = foothold_m - start_;
  gait::PointMotion motion{.position = start_ + along.value * way,
                           .velocity = along.slope * forward_rate * way,
                           .acceleration = along.curvature * forward_rate * forward_rate * way};
  // two halves of the swing, each a step between lift-off, apex and end
  const double end = foothold_m.z() - params_.press_m;
  const double apex = std::max(start_.z(), foothold_m.z()) + params_.height_m;
  const bool rises = progress < 0.5;
  const gait::Smooth half = gait::smooth_step(rises ? 2.0 * progress : 2.0 * progress - 1.0);
  const double from = rises ? start_.z() : apex;
  const double change = (rises ? apex : end) - from;
  motion.position.z() = from + half.value * change;
  motion.velocity.z() = 2.0 * rate * half.slope * change;
  motion.acceleration.z() = 4.0 * rate * rate * half.curvature * change;
  return motion;
}

gait::PointMotion SwingTrajectory::reach(double late_s, const Eigen::Vector3d& foothold_m) const noexcept {
  const double depth = std::min(params_.reach_speed_m_s * late_s, params_.reach_depth_m);
  gait::PointMotion motion;
  motion.position = foothold_m - Eigen::Vector3d{0.0, 0.0, params_.press_m + depth};
  motion.velocity.z() = depth < params_.reach_depth_m ? -params_.reach_speed_m_s : 0.0;
  return motion;
}

}  // namespace farrier::locomotion
