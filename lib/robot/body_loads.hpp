#pragma once

#include <span>

#include "body/model/body_state.hpp"
#include "robot/robot.hpp"

namespace farrier::robot {

/// Inertia that each joint turns while all others are free and the feet of `standing` legs do not move, kg m^2. It is
/// 1 / A_ii, where A follows from the mass matrix M and the Jacobians J of those feet:
///   A = M^-1 - M^-1 J' (J M^-1 J')^-1 J M^-1.
/// This is the elimination of the feet's forces from the equations of motion in rigid_body.hpp. The robot is at rest at
/// these angles (rad). The model must pass body::validate.
body::JointVector joint_inertias_kg_m2(const body::BodyModel& model, const body::JointVector& angles_rad,
                                       std::span<const int> standing);

/// Gives the joints of a robot with a body what they move on a ground. The armature of a hydraulic joint is its piston's
/// mass by the square of the lever at home. The loads for swing and stance have the inertia of joint_inertias_kg_m2 at
/// home, in the middle of the planned swing or stance of the leg, and the damping of the hinge. A joint of a leg that
/// never swings has the same inertia as if it lifted that leg alone. Loads are in the actuator's coordinates.
void put_loads_of_body(Robot& robot);

}  // namespace farrier::robot
