#pragma once

// Spatial vectors of Featherstone (2008), "Rigid Body Dynamics Algorithms", chapter 2. All share one frame, so no
// transformation stands between two bodies: its axes are the world's and its origin is the trunk's at this instant.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace farrier::body {

/// A spatial velocity or acceleration: rad/s and m/s, or rad/s^2 and m/s^2, of the point at the frame's origin.
struct Motion {
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();

  Motion operator+(const Motion& b) const noexcept { return {angular + b.angular, linear + b.linear}; }
  Motion operator*(double factor) const noexcept { return {angular * factor, linear * factor}; }
};

/// A spatial force or momentum: the moment is about the frame's origin.
struct Force {
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();

  Force operator+(const Force& b) const noexcept { return {moment + b.moment, linear + b.linear}; }
};

/// v x m, section 2.9.
inline Motion cross(const Motion& v, const Motion& m) noexcept {
  return {v.angular.cross(m.angular), v.angular.cross(m.linear) + v.linear.cross(m.angular)};
}

/// v x* f, section 2.9.
inline Force cross(const Motion& v, const Force& f) noexcept {
  return {v.angular.cross(f.moment) + v.linear.cross(f.linear), v.angular.cross(f.linear)};
}

inline double power(const Motion& m, const Force& f) noexcept {
  return m.angular.dot(f.moment) + m.linear.dot(f.linear);
}

/// Spatial inertia, eq. (2.63): mass m, first moment h = m c, and the tensor about the frame's origin,
/// I = I_c + m (c'c 1 - c c').
struct SpatialInertia {
  double mass_kg = 0.0;
  Eigen::Vector3d first_moment_kg_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d tensor_kg_m2 = Eigen::Matrix3d::Zero();

  static SpatialInertia of(double mass_kg, const Eigen::Vector3d& com_m, const Eigen::Matrix3d& about_com_kg_m2) {
    const Eigen::Matrix3d steiner = com_m.squaredNorm() * Eigen::Matrix3d::Identity() - com_m * com_m.transpose();
    return {mass_kg, mass_kg * com_m, about_com_kg_m2 + mass_kg * steiner};
  }

  SpatialInertia operator+(const SpatialInertia& b) const noexcept {
    return {mass_kg + b.mass_kg, first_moment_kg_m + b.first_moment_kg_m, tensor_kg_m2 + b.tensor_kg_m2};
  }

  Force operator*(const Motion& m) const noexcept {
    return {tensor_kg_m2 * m.angular + first_moment_kg_m.cross(m.linear),
            mass_kg * m.linear - first_moment_kg_m.cross(m.angular)};
  }
};

}  // namespace farrier::body
