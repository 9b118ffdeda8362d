#pragma once

#include <Eigen/Core>

#include "locomotion/controller.hpp"
#include "locomotion/ground_plane.hpp"
#include "locomotion/trunk_wrench.hpp"

namespace farrier::locomotion {

/// Limits of the motion that the trunk is asked for.
struct TrunkReferenceParams {
  double default_height_m = 0.58;  ///< trunk's origin above the ground, > 0
  double least_height_m = 0.40;
  double largest_height_m = 0.66;
  double height_speed_m_s = 0.15;    ///< while standing up, sitting down and on command, > 0
  double fastest_forward_m_s = 1.2;  ///< commands are clamped to these, >= 0
  double fastest_left_m_s = 0.5;
  double fastest_yaw_rad_s = 0.8;
  double acceleration_m_s2 = 0.5;  ///< ramp of the velocities, > 0
  double yaw_acceleration_rad_s2 = 1.0;
  double position_slack_m = 0.10;  ///< largest position error that the trunk is pulled by, >= 0
  double yaw_slack_rad = 0.3;      ///< largest yaw error, >= 0
  double tilt_share = 1.0;         ///< part of the ground's slope that the trunk follows, 0..1
};

/// Trunk motion that the operator asks for: velocities with ramps, the position and heading that follow, and the attitude
/// of the ground.
class TrunkReference {
 public:
  TrunkReference(const TrunkReferenceParams& params, double period_s) noexcept : params_(params), period_s_(period_s) {}

  /// Starts from where the trunk is, at rest.
  void reset(const TrunkState& trunk, double height_m) noexcept;

  /// Advances by one tick. `moving` false takes the commanded velocities as zero.
  void step(const MotionCommand& command, bool moving, double height_m, const TrunkState& trunk,
            const GroundPlane& ground) noexcept;

  const TrunkState& wanted() const noexcept { return wanted_; }
  double yaw_rate_rad_s() const noexcept { return yaw_rate_; }
  double height_m() const noexcept { return height_m_; }
  /// Height that the command asks for, within the limits.
  double commanded_height_m(const MotionCommand& command) const noexcept;
  /// True while velocities are zero.
  bool at_rest() const noexcept { return velocity_.isZero() && yaw_rate_ == 0.0; }

 private:
  void ramp(const MotionCommand& command, bool moving) noexcept;
  void turn(const Eigen::Matrix3d& heading) noexcept;

  TrunkReferenceParams params_;
  double period_s_;
  Eigen::Vector2d velocity_ = Eigen::Vector2d::Zero();  // forward, left
  double yaw_rate_ = 0.0;
  double height_m_ = 0.0;
  Eigen::Matrix3d heading_ = Eigen::Matrix3d::Identity();
  TrunkState wanted_;
};

}  // namespace farrier::locomotion
