#pragma once

#include <optional>
#include <string>

#include "core/result.hpp"
#include "robot/robot.hpp"
#include "sim_bridge/simulated_robot.hpp"
#include "trace/body_trace.hpp"
#include "trace/supply_trace.hpp"
#include "trace/trace.hpp"

namespace farrier::sim_bridge {

/// The files of a run's trace.
struct Traces {
  std::optional<trace::TraceWriter> joints;        ///< none for an empty path
  std::optional<trace::BodyTraceWriter> body;      ///< likewise, and none without a body
  std::optional<trace::SupplyTraceWriter> supply;  ///< likewise, and none without a pump

  /// Refuses a path that cannot be written.
  static Result<Traces> create(const std::string& path, const robot::Robot& robot, const SimulatedRobot& world);

  /// Flushes all; false when the disk did not take everything.
  [[nodiscard]] bool finish();
};

}  // namespace farrier::sim_bridge
