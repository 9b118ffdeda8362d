#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

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
  return {normal.dot(position_m), portable::acos(std::clamp(cosine, -1.0, 1.0))};
}

/// Why a robot counts as fallen.
enum class FallReason {
  kHeight,  ///< the trunk's origin is below half its height at the start; a robot on folded legs is above that
  kTilt,    ///< the trunk tilts by more than 45 degrees
};

constexpr const char* to_string(FallReason reason) noexcept {
  return reason == FallReason::kHeight ? "height" : "tilt";
}

/// The rule of every verdict. None for a robot that has not fallen; the tilt if both hold.
inline std::optional<FallReason> fall_of(const Posture& posture, double start_height_m) noexcept {
  constexpr double kShare = 0.5;
  constexpr double kTilt_rad = 0.25 * std::numbers::pi;
  if (posture.tilt_rad > kTilt_rad) {
    return FallReason::kTilt;
  }
  return posture.height_m < kShare * start_height_m ? std::optional(FallReason::kHeight) : std::nullopt;
}

}  // namespace farrier::body
