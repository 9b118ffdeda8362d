#pragma once

#include <cstdint>
#include <vector>

#include "robot/robot.hpp"

namespace farrier::trials {

/// Deviations of one joint of a varied robot.
struct JointDraw {
  double friction_factor;  ///< on the damping of the load, in swing and stance
  double valve_factor;     ///< on the valve gain
  double stance_mass;      ///< kg on a cylinder; a motor's load is the leg and keeps its kg m^2
};

struct Draw {
  double supply_factor;           ///< on the supply pressure of the whole robot
  std::vector<JointDraw> joints;  ///< in the order of Robot::joints
};

/// The robot with the body of its varied kind, Variation::body_mass_kg: what the gait carries, and so what the world and
/// every controller are asked for. Loads on cylinders are drawn, the leg about a hip stays.
robot::Robot with_varied_body(robot::Robot nominal);

/// Draws from `seed` for this robot between the ends of its `variation`. Addressed by (seed, joint's name, quantity):
/// neither the order nor the number of the joints changes a joint's numbers.
Draw draw_variation(const robot::Robot& nominal, std::uint64_t seed);

/// The robot with these actuators and loads. The data that the gait and the joints use stay nominal: RobotPlan, force
/// limits, scales and weights of the controller, and the file.
robot::Robot varied(const robot::Robot& nominal, const Draw& draw);

}  // namespace farrier::trials
