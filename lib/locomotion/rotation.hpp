#pragma once

#include <Eigen/Core>

namespace farrier::locomotion {

inline constexpr double kGravity_m_s2 = 9.81;

/// Matrix of the cross product: skew(a) b = a x b.
Eigen::Matrix3d skew(const Eigen::Vector3d& a) noexcept;

/// Rotation by the vector `angle_rad`, |angle| < 8 rad: exp(skew(angle)) (Rodrigues 1840). It uses the plant's
/// trigonometry, so the bits are the same on every machine.
Eigen::Matrix3d rotation_by(const Eigen::Vector3d& angle_rad) noexcept;

/// sin(theta) u for the rotation R by theta about the unit vector u: the vector of (R - R^T) / 2. Equals the rotation
/// vector to third order in theta.
Eigen::Vector3d sine_vector(const Eigen::Matrix3d& rotation) noexcept;

/// Removes rounding errors from a rotation that is integrated: one step of R <- R (3 I - R^T R) / 2 (Bjorck 1971).
Eigen::Matrix3d orthonormalised(const Eigen::Matrix3d& rotation) noexcept;

/// Rotation about z with the heading of `rotation`: its x axis is the trunk's x axis in the plane.
/// Identity if that axis is vertical.
Eigen::Matrix3d heading_of(const Eigen::Matrix3d& rotation) noexcept;

/// The smallest rotation that turns z into the unit vector `up`, |up - (0, 0, -1)| > 0.
Eigen::Matrix3d tilt_to(const Eigen::Vector3d& up) noexcept;

}  // namespace farrier::locomotion
