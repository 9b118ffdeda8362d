#pragma once

#include <cstdint>
#include <vector>

#include "robot/robot.hpp"

namespace farrier::lab {

/// Bounds between which varied() draws, every value uniformly.
struct Range {
  double low, high;
};
inline constexpr Range kSupplyFactor{0.7, 1.3};
inline constexpr Range kFrictionFactor{1.0, 5.0};
inline constexpr Range kValveFactor{0.8, 1.2};
inline constexpr Range kStanceMass_kg{10.0, 80.0};

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

/// What `seed` draws for this robot. Addressed by (seed, joint's name, quantity): neither the order of the joints nor
/// how many there are changes a joint's numbers.
Draw draw_variation(const robot::Robot& nominal, std::uint64_t seed);

/// The robot with these actuators and loads. What the gait and the joints believe (RobotPlan, force limits, scales and
/// weights of the controller, the file) stays nominal.
robot::Robot varied(const robot::Robot& nominal, const Draw& draw);

}  // namespace farrier::lab
