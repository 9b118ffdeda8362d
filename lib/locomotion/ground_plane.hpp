#pragma once

#include <Eigen/Core>

#include "locomotion/body_model.hpp"

namespace farrier::locomotion {

/// Estimate of the ground under the robot.
struct GroundPlaneParams {
  double time_constant_s = 0.15;  ///< of the low-pass on height and slope, > 0
  double largest_slope = 0.45;    ///< rise per metre in either direction, > 0; 0.45 are 24 degrees
};

/// Plane through the last footholds by least squares, low-pass filtered. The slopes are those along the trunk's heading,
/// so a turn on a slope turns them as well.
class GroundPlane {
 public:
  GroundPlane(const GroundPlaneParams& params, double period_s) noexcept : params_(params), period_s_(period_s) {}

  /// Level ground at `height_m`.
  void reset(double height_m) noexcept;

  /// Takes the places (world frame, m) where `count` feet last touched the ground, relative to `center_m`, which should
  /// be the trunk's place. `heading` is the rotation about z to the trunk's heading. Fewer than three feet, or feet on a
  /// line, leave the slope as it is.
  void update(const PerLeg<Eigen::Vector3d>& footholds_m, int count, const Eigen::Vector3d& center_m,
              const Eigen::Matrix3d& heading) noexcept;

  /// Height below `place_m`, m, world frame.
  double height_at(const Eigen::Vector3d& place_m) const noexcept;

  /// Unit normal, world frame, upwards.
  Eigen::Vector3d normal() const noexcept;

 private:
  GroundPlaneParams params_;
  double period_s_;
  Eigen::Vector3d center_ = Eigen::Vector3d::Zero();  // where height_ holds
  Eigen::Matrix3d heading_ = Eigen::Matrix3d::Identity();
  double height_ = 0.0;
  Eigen::Vector2d slope_ = Eigen::Vector2d::Zero();  // forward, left
};

}  // namespace farrier::locomotion
