#include "sim_bridge/traces.hpp"

#include "robot/keys.hpp"

namespace farrier::sim_bridge {

Result<Traces> Traces::create(const std::string& path, const robot::Robot& robot, const SimulatedRobot& world) {
  Traces traces;
  if (path.empty()) {
    return traces;
  }
  traces.joints = FARRIER_TRY(trace::TraceWriter::create(path, robot::joint_names(robot)));
  if (world.truth()) {
    traces.body = FARRIER_TRY(
        trace::BodyTraceWriter::create(trace::body_trace_path(path), static_cast<int>(robot.plan.legs.size())));
  }
  if (world.supply_state() != nullptr) {
    traces.supply = FARRIER_TRY(trace::SupplyTraceWriter::create(trace::supply_trace_path(path)));
  }
  return traces;
}

bool Traces::finish() {
  const bool joints_complete = !joints || joints->finish();
  const bool body_complete = !body || body->finish();
  const bool supply_complete = !supply || supply->finish();
  return joints_complete && body_complete && supply_complete;
}

}  // namespace farrier::sim_bridge
