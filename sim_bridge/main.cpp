// sim_bridge: valve_command ──▶ simulated joints on bench loads, or a body on a ground ──▶ joint/sensors, body/imu; drives
// the clock

#include "process/process.hpp"
#include "sim_bridge/sim_bridge_lockstep.hpp"
#include "sim_bridge/sim_bridge_realtime.hpp"

namespace {

using farrier::Result;
using farrier::robot::Robot;

/// The robot of --robot on its bench or as a body, or with --simulated-robot another one in its place.
Result<std::unique_ptr<farrier::sim_bridge::SimulatedRobot>> world_of(
    const Robot& known, const farrier::participant::ProcessOptions& options) {
  using namespace farrier;
  const auto make = [&options](const Robot& robot) {
    return participant::is_on_ground(options.world)
               ? sim_bridge::simulated_body(robot, options.scene_path, options.seed,
                                            options.world == participant::World::kIdeal)
               : sim_bridge::simulated_bench(robot, options.seed);
  };
  if (options.simulated_path.empty()) {
    return make(known);
  }
  const auto other =
      robot::load_robot(options.simulated_path, {.on_ground = options.world == participant::World::kBody});
  if (!other) {
    return Error{config::to_string(other.error())};
  }
  FARRIER_TRY(sim_bridge::check_supply(known, other.value()));
  return make(other.value());
}

}  // namespace

int main(int argc, char** argv) {
  using namespace farrier;
  const auto o = participant::parse_options("sim_bridge", "Simulates the robot", argc, argv);
  return process::run(
      o,
      [&](auto& member, const auto& robot) -> Result<std::unique_ptr<participant::Application>> {
        auto world = FARRIER_TRY(world_of(robot, o));
        return sim_bridge::create_lockstep(std::move(world), robot, o.trace_path, member, o.ticks);
      },
      [&](auto& member, const auto& robot) -> Result<std::unique_ptr<participant::RealtimeApplication>> {
        auto world = FARRIER_TRY(world_of(robot, o));
        return sim_bridge::create_realtime(std::move(world), robot, o.trace_path, member, o.ticks);
      });
}
