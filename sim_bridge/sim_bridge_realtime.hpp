#pragma once

#include <memory>
#include <string>

#include "participant/participant.hpp"
#include "participant/realtime_loop.hpp"
#include "robot/robot.hpp"
#include "sim_bridge/simulated_robot.hpp"

namespace farrier::sim_bridge {

/// The simulated robot on the real-time clock: advances every period on absolute deadlines with the newest valve
/// commands; a joint that has had none for safety.valve_silent_s gets a null spool.
Result<std::unique_ptr<participant::RealtimeApplication>> create_realtime(std::unique_ptr<SimulatedRobot> world,
                                                                          const robot::Robot& robot,
                                                                          const std::string& trace_path,
                                                                          participant::Participant& participant,
                                                                          Tick ticks);

}  // namespace farrier::sim_bridge
