// sim_bridge: valve_command ──▶ simulated hydraulic joints and bench loads ──▶ joint/sensors; drives the clock

#include "process/process.hpp"
#include "sim_bridge/sim_bridge_lockstep.hpp"
#include "sim_bridge/sim_bridge_realtime.hpp"

int main(int argc, char** argv) {
  using namespace farrier;
  const auto o = participant::parse_options("sim_bridge", "Simulates the robot's hydraulic joints", argc, argv);
  return process::run(
      o,
      [&](auto& member, const auto& robot) {
        return sim_bridge::create_lockstep(robot, o.seed, o.trace_path, member, o.ticks);
      },
      [&](auto& member, const auto& robot) {
        return sim_bridge::create_realtime(robot, o.seed, o.trace_path, member, o.ticks);
      });
}
