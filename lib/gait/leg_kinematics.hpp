#pragma once

#include <Eigen/Core>
#include <optional>

#include "gait/gait_params.hpp"

namespace farrier::gait {

// Frame of the hip: origin where the HAA axis meets the leg's plane, x forward, y left, z up. Joint angles are (HAA,
// HFE, KFE) in rad, all zero for a leg hanging straight down; positions are of the foot sphere's centre in m. The foot
// is at
//   x = -l_1 sin q_1 - l_2 sin(q_1 + q_2),   d = h + l_1 cos q_1 + l_2 cos(q_1 + q_2),
//   y = -s d sin q_0,                        z = -d cos q_0.
// Here s = +1 left, -1 right, and h, l_1, l_2 are the hip offset and the lengths of upper and lower leg. Positive HFE
// moves the knee backward, negative HAA the foot outward.

/// Position of the foot.
Eigen::Vector3d fk(const LegGeometry& geometry, const Eigen::Vector3d& angles_rad) noexcept;

/// The angles that put the foot there, the knee bent backward for front legs and forward for hind legs, |HAA| < pi/2.
/// Empty where the leg does not reach or the foot is not below the HAA axis.
std::optional<Eigen::Vector3d> ik(const LegGeometry& geometry, const Eigen::Vector3d& foot_m) noexcept;

/// J = d fk / dq, 3 x 3, m/rad. Singular for a straight knee.
Eigen::Matrix3d jacobian(const LegGeometry& geometry, const Eigen::Vector3d& angles_rad) noexcept;

/// dJ/dt at these angles and velocities (rad/s), 3 x 3, m/(rad s).
Eigen::Matrix3d jacobian_rate(const LegGeometry& geometry, const Eigen::Vector3d& angles_rad,
                              const Eigen::Vector3d& velocities_rad_s) noexcept;

/// Joint torques J^T (0, 0, f) in Nm that the ground causes when it pushes the foot up with f newtons; an actuator
/// that holds the leg applies the opposite.
Eigen::Vector3d ground_torques(const LegGeometry& geometry, const Eigen::Vector3d& angles_rad,
                               double vertical_force_N) noexcept;

}  // namespace farrier::gait
