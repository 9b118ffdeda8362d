#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/portable_math.hpp"

namespace farrier::body {

/// The trunk relative to the ground's plane through the world's origin.
struct Posture {
  double height_m;  ///< of the trunk's origin, along the normal
  double tilt_rad;  ///< between the trunk's z axis and the normal
};

inline Posture posture_of(const Eigen::Vector3d& position_m, const Eigen::Quaterniond& attitude,
                          const Eigen::Vector3d& normal) {
  const double cosine = normal.dot(attitude * Eigen::Vector3d::UnitZ());
  return {normal.dot(position_m), portable_math::arc_cosine(std::clamp(cosine, -1.0, 1.0))};
}

/// The rule of every verdict: a robot has fallen if its trunk is below half its height at the start, or tilts by more
/// than 45 degrees. A robot that lies on folded legs is above that height.
inline bool has_fallen(const Posture& posture, double start_height_m) noexcept {
  constexpr double kShare = 0.5;
  constexpr double kTilt_rad = 0.25 * std::numbers::pi;
  return posture.height_m < kShare * start_height_m || posture.tilt_rad > kTilt_rad;
}

}  // namespace farrier::body
