#pragma once

#include <Eigen/Core>

namespace farrier::gait {

/// One stride of a foot relative to its neutral place under the hip (hip frame: x forward, z up).
struct FootPath {
  double step_length_m;  ///< S, way during stance
  double step_height_m;  ///< H, lift in mid-swing
  double stance_s;       ///< T_s, > 0
  double swing_s;        ///< T_w, > 0
};

/// Position (m), velocity (m/s) and acceleration (m/s^2) of one point.
struct PointMotion {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
};

/// Motion of the foot `since_touchdown_s` after touchdown, up to T_s + T_w. In stance it moves backward at the constant
/// speed S / T_s; negative times continue that line. In swing it returns with position, velocity, acceleration and jerk
/// continuous at lift-off and touchdown. The acceleration is zero at both and still small some milliseconds before and
/// after, when an early or late touchdown changes the load.
PointMotion foot_motion(const FootPath& path, double since_touchdown_s) noexcept;

}  // namespace farrier::gait
