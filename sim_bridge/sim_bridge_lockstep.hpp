#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "participant/application.hpp"
#include "participant/participant.hpp"
#include "trace/trace.hpp"
#include "robot/robot.hpp"
#include "sim_bridge/simulated_robot.hpp"

namespace farrier::sim_bridge {

/// Takes the rows of a trace, tick by tick, joint by joint.
using RowSink = std::function<void(const trace::TraceRow&)>;

/// The simulated robot in lock-step, and the lock-step clock itself. Tick k + 1 begins only when every joint has
/// answered tick k, every participant has finished it, and all its issued samples have arrived here. Empty
/// `trace_path`: no trace. With `ticks` 0 it runs until told to stop. The `sink`, if there is one, gets every row beside
/// the trace and must not throw.
Result<std::unique_ptr<participant::Application>> create_lockstep(std::unique_ptr<SimulatedRobot> world,
                                                                  const robot::Robot& robot,
                                                                  const std::string& trace_path,
                                                                  participant::Participant& participant, Tick ticks,
                                                                  RowSink sink = {});

}  // namespace farrier::sim_bridge
