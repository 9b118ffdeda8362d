#pragma once

#include "robot/robot.hpp"

namespace farrier::urdf {

/// Limits of a joint as a URDF has them, in the angle of joint/sensors.
struct JointLimits {
  double lower_rad;
  double upper_rad;
  double effort_Nm;        ///< largest torque anywhere between the limits, in either direction
  double least_effort_Nm;  ///< the smallest of the largest torques; a URDF has no place for it
  double velocity_rad_s;   ///< largest speed anywhere between the limits, without a load
};

/// The limits of a joint with its linkage. Torques are lever times push_limit or pull_limit. The speed of an electric
/// joint is that of its file or its no-load speed. A cylinder extends without a load, its valve fully open, at
/// K_v u_max sqrt((p_s - alpha p_t) / (1 + alpha^3)) / A_p (Merritt 1967, orifice law on both sides of the piston).
JointLimits limits_of(const robot::Joint& joint, const robot::RobotFile& file);

}  // namespace farrier::urdf
