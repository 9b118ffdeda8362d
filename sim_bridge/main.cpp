// sim_bridge: valve_command ──▶ simulated hydraulic joints and bench loads ──▶ joint/sensors; drives the clock

#include "process/process.hpp"
#include "sim_bridge/sim_bridge_lockstep.hpp"
#include "sim_bridge/sim_bridge_realtime.hpp"

namespace {

using farrier::Result;
using farrier::robot::Robot;

/// The robot to simulate: the one that everybody knows, or with --world another one.
Result<Robot> world_of(const Robot& robot, const farrier::participant::ProcessOptions& options) {
  if (options.world_path.empty()) {
    return robot;
  }
  auto world = farrier::robot::load_robot(options.world_path);
  if (!world) {
    return farrier::Error{farrier::config::to_string(world.error())};
  }
  return std::move(world).value();
}

}  // namespace

int main(int argc, char** argv) {
  using namespace farrier;
  const auto o = participant::parse_options("sim_bridge", "Simulates the robot's hydraulic joints", argc, argv);
  return process::run(
      o,
      [&](auto& member, const auto& robot) -> Result<std::unique_ptr<participant::Application>> {
        auto world = FARRIER_TRY(world_of(robot, o));
        return sim_bridge::create_lockstep(std::move(world), o.seed, o.trace_path, member, o.ticks);
      },
      [&](auto& member, const auto& robot) -> Result<std::unique_ptr<participant::RealtimeApplication>> {
        auto world = FARRIER_TRY(world_of(robot, o));
        return sim_bridge::create_realtime(std::move(world), o.seed, o.trace_path, member, o.ticks);
      });
}
