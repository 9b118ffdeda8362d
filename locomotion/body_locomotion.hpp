#pragma once

#include <vector>

#include "locomotion/controller.hpp"
#include "locomotion/locomotion.hpp"
#include "locomotion/motion_script.hpp"

namespace farrier::locomotion {

/// The script of a body that stands up and trots with this velocity, as ProcessOptions has it; empty for none, which
/// leaves it lying.
std::vector<TimedCommand> script_of(const std::vector<double>& velocity);

/// Runs a controller of the whole robot: joint/sensors and body/imu of tick k give torques for tick k + 1. The script
/// commands it until the first body/command arrives. `ticks` 0: until told to stop. With `hears_supply` it also takes
/// supply/state, and a SupplyGuard stands between command and controller: for actuators with a pump, else refused.
Result<std::unique_ptr<Locomotion>> create_body_locomotion(const robot::Robot& robot,
                                                           std::unique_ptr<Controller> controller,
                                                           std::vector<TimedCommand> script,
                                                           participant::Participant& participant, Tick ticks,
                                                           bool hears_supply = false);

/// The same with the shipped TrotController. Refuses a robot whose file has no body.trunk or no locomotion.
Result<std::unique_ptr<Locomotion>> create_trot_locomotion(const robot::Robot& robot, std::vector<TimedCommand> script,
                                                           participant::Participant& participant, Tick ticks,
                                                           bool hears_supply = false);

}  // namespace farrier::locomotion
