#include "gait/leg_kinematics.hpp"

#include <cmath>

#include "core/portable_math.hpp"

namespace farrier::gait {
namespace {

double side(const LegGeometry& geometry) noexcept { return geometry.left ? 1.0 : -1.0; }

// The leg within its own plane, and how that changes with HFE (1) and KFE (2).
struct PlaneLeg {
  double x, d;      // forward, and down from the HAA axis
  double x_1, x_2;  // dx/dq_1, dx/dq_2
  double d_1, d_2;
};

PlaneLeg plane_leg(const LegGeometry& geometry, double q_1, double q_2) noexcept {
  const double l_1 = geometry.upper_m;
  const double l_2 = geometry.lower_m;
  const double s_1 = portable::sin(q_1), c_1 = portable::cos(q_1);
  const double s_12 = portable::sin(q_1 + q_2), c_12 = portable::cos(q_1 + q_2);
  return {.x = -l_1 * s_1 - l_2 * s_12,
          .d = geometry.hip_offset_m + l_1 * c_1 + l_2 * c_12,
          .x_1 = -l_1 * c_1 - l_2 * c_12,
          .x_2 = -l_2 * c_12,
          .d_1 = -l_1 * s_1 - l_2 * s_12,
          .d_2 = -l_2 * s_12};
}

}  // namespace

Eigen::Vector3d fk(const LegGeometry& geometry, const Eigen::Vector3d& angles_rad) noexcept {
  const PlaneLeg leg = plane_leg(geometry, angles_rad[1], angles_rad[2]);
  return {leg.x, -side(geometry) * leg.d * portable::sin(angles_rad[0]), -leg.d * portable::cos(angles_rad[0])};
}

std::optional<Eigen::Vector3d> ik(const LegGeometry& geometry, const Eigen::Vector3d& foot_m) noexcept {
  const double l_1 = geometry.upper_m;
  const double l_2 = geometry.lower_m;
  // r: from HFE down to the foot, in the leg's plane
  const double r = std::hypot(foot_m.y(), foot_m.z()) - geometry.hip_offset_m;
  // law of cosines: x^2 + r^2 = l_1^2 + l_2^2 + 2 l_1 l_2 cos q_2
  const double knee_cosine = (foot_m.x() * foot_m.x() + r * r - l_1 * l_1 - l_2 * l_2) / (2.0 * l_1 * l_2);
  const bool reached = std::abs(knee_cosine) <= 1.0 && foot_m.z() < 0.0;  // false for NaN as well
  if (!reached) {
    return std::nullopt;
  }
  const double q_0 = portable::atan2(-side(geometry) * foot_m.y(), -foot_m.z());
  const double q_2 = geometry.front ? -portable::acos(knee_cosine) : portable::acos(knee_cosine);
  const double q_1 =
      portable::atan2(-foot_m.x(), r) - portable::atan2(l_2 * portable::sin(q_2), l_1 + l_2 * portable::cos(q_2));
  return Eigen::Vector3d{q_0, q_1, q_2};
}

Eigen::Matrix3d jacobian(const LegGeometry& geometry, const Eigen::Vector3d& angles_rad) noexcept {
  const PlaneLeg leg = plane_leg(geometry, angles_rad[1], angles_rad[2]);
  const double s = side(geometry);
  const double s_0 = portable::sin(angles_rad[0]), c_0 = portable::cos(angles_rad[0]);
  Eigen::Matrix3d j;
  j << 0.0, leg.x_1, leg.x_2,                                    //
      -s * leg.d * c_0, -s * s_0 * leg.d_1, -s * s_0 * leg.d_2,  //
      leg.d * s_0, -c_0 * leg.d_1, -c_0 * leg.d_2;
  return j;
}

Eigen::Matrix3d jacobian_rate(const LegGeometry& geometry, const Eigen::Vector3d& angles_rad,
                              const Eigen::Vector3d& velocities_rad_s) noexcept {
  const PlaneLeg leg = plane_leg(geometry, angles_rad[1], angles_rad[2]);
  const double s = side(geometry);
  const double s_0 = portable::sin(angles_rad[0]), c_0 = portable::cos(angles_rad[0]);
  const double w_0 = velocities_rad_s[0];
  const double w_12 = velocities_rad_s[1] + velocities_rad_s[2];
  // second derivatives in the plane: x_11 = -d_1, x_12 = x_22 = -d_2, d_11 = x_1, d_12 = d_22 = x_2
  const double x_1_dot = -leg.d_1 * velocities_rad_s[1] - leg.d_2 * velocities_rad_s[2];
  const double x_2_dot = -leg.d_2 * w_12;
  const double d_1_dot = leg.x_1 * velocities_rad_s[1] + leg.x_2 * velocities_rad_s[2];
  const double d_2_dot = leg.x_2 * w_12;
  const double d_dot = leg.d_1 * velocities_rad_s[1] + leg.d_2 * velocities_rad_s[2];
  Eigen::Matrix3d j_dot;
  j_dot << 0.0, x_1_dot, x_2_dot,  //
      -s * (d_dot * c_0 - leg.d * s_0 * w_0), -s * (c_0 * w_0 * leg.d_1 + s_0 * d_1_dot),
      -s * (c_0 * w_0 * leg.d_2 + s_0 * d_2_dot),  //
      d_dot * s_0 + leg.d * c_0 * w_0, s_0 * w_0 * leg.d_1 - c_0 * d_1_dot, s_0 * w_0 * leg.d_2 - c_0 * d_2_dot;
  return j_dot;
}

Eigen::Vector3d ground_torques(const LegGeometry& geometry, const Eigen::Vector3d& angles_rad,
                               double vertical_force_N) noexcept {
  return jacobian(geometry, angles_rad).row(2).transpose() * vertical_force_N;
}

}  // namespace farrier::gait
