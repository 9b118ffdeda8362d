#pragma once

#include <Eigen/Core>

#include "gait/foot_path.hpp"

namespace farrier::locomotion {

/// Path of a swinging foot.
struct SwingParams {
  double height_m = 0.14;        ///< apex above the higher of lift-off and foothold, >= 0
  double forward_share = 1.0;    ///< share of the swing after which the foot is over its foothold, 0.5..1
  double press_m = 0.02;         ///< the path ends this far below the expected ground, >= 0
  double reach_speed_m_s = 0.4;  ///< downward speed after a swing without contact, > 0
  double reach_depth_m = 0.15;   ///< lowest place of that search below the end of the path, >= 0
};

/// Path of a foot from lift-off to a foothold that may move meanwhile. World frame, smooth_step() in each direction:
/// the foot rises over the first half and falls over the second; it moves forward during the first `forward_share`.
/// Position, velocity and acceleration are continuous.
/// After the swing the foot goes on downwards, until the caller sees a contact.
class SwingTrajectory {
 public:
  explicit SwingTrajectory(const SwingParams& params) noexcept : params_(params) {}

  /// Begins a swing at the foot's place.
  void lift_off(const Eigen::Vector3d& foot_m) noexcept { start_ = foot_m; }

  /// Motion at `progress` (0..1) of a swing that takes `swing_s`, towards `foothold_m` on the ground.
  gait::PointMotion at(double progress, double swing_s, const Eigen::Vector3d& foothold_m) const noexcept;

  /// Motion `late_s` after the end of the swing.
  gait::PointMotion reach(double late_s, const Eigen::Vector3d& foothold_m) const noexcept;

 private:
  SwingParams params_;
  Eigen::Vector3d start_ = Eigen::Vector3d::Zero();
};

}  // namespace farrier::locomotion
