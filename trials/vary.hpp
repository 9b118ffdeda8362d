#pragma once

#include <cstdint>
#include <vector>

#include "robot/robot.hpp"

namespace farrier::trials {

/// What one joint of a varied robot differs in.
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

/// What `seed` draws for this robot between the ends of its `variation`. Addressed by (seed, joint's name, quantity): neither the order of the joints nor
/// how many there are changes a joint's numbers.
Draw draw_variation(const robot::Robot& nominal, std::uint64_t seed);

/// The robot with these actuators and loads. What the gait and the joints believe (RobotPlan, force limits, scales and
/// weights of the controller, the file) stays nominal.
robot::Robot varied(const robot::Robot& nominal, const Draw& draw);

}  // namespace farrier::trials
