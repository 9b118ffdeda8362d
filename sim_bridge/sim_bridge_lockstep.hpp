#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "participant/application.hpp"
#include "participant/participant.hpp"
#include "trace/trace.hpp"
#include "robot/load_change.hpp"
#include "robot/robot.hpp"

namespace farrier::sim_bridge {

/// Takes what the trace would record, tick by tick, joint by joint.
using RowSink = std::function<void(const trace::TraceRow&)>;

/// The simulated robot in lock-step, and the lock-step clock itself: tick k + 1 begins only when every joint has
/// answered tick k, every participant has finished it, and all it issued has arrived here.
/// `trace_path` empty: no trace. `ticks` 0: until told to stop. `load_changes` as SimWorld::create takes them. `sink`,
/// where there is one, gets every row beside the trace and must not throw.
Result<std::unique_ptr<participant::Application>> create_lockstep(const robot::Robot& robot, std::uint64_t seed,
                                                                  const std::string& trace_path,
                                                                  participant::Participant& participant, Tick ticks,
                                                                  std::vector<robot::LoadChange> load_changes = {},
                                                                  RowSink sink = {});

}  // namespace farrier::sim_bridge
