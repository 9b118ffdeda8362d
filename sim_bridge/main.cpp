// sim_bridge: valve_command ──▶ simulated hydraulic joints and bench loads ──▶ joint/sensors; drives the clock

#include "trials/hide.hpp"
#include "process/process.hpp"
#include "sim_bridge/sim_bridge_lockstep.hpp"
#include "sim_bridge/sim_bridge_realtime.hpp"

namespace {

/// What is simulated: the robot, or with --hide a secret one.
farrier::robot::Robot world_of(const farrier::robot::Robot& robot, const farrier::participant::ProcessOptions& o) {
  farrier::trials::HiddenEffect unsaid;
  return o.hide ? farrier::trials::hide_effect(robot, *o.hide, unsaid) : robot;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace farrier;
  const auto o = participant::parse_options("sim_bridge", "Simulates the robot's hydraulic joints", argc, argv);
  return process::run(
      o,
      [&](auto& member, const auto& robot) {
        return sim_bridge::create_lockstep(world_of(robot, o), o.seed, o.trace_path, member, o.ticks);
      },
      [&](auto& member, const auto& robot) {
        return sim_bridge::create_realtime(world_of(robot, o), o.seed, o.trace_path, member, o.ticks);
      });
}
