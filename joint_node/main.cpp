// joint_node: sensors + command + controller_gains + gait/phase ──▶ force loop ──▶ valve_command, measurement

#include "joint_node/joint_node_lockstep.hpp"
#include "joint_node/joint_node_realtime.hpp"
#include "process/process.hpp"

int main(int argc, char** argv) {
  using namespace farrier;
  const auto options = participant::parse_options("joint_node", "Torque loops of the joints it hosts", argc, argv);
  return process::run(
      options,
      [&](auto& member, const auto& robot) {
        return joint_node::create_lockstep(robot, options.joints, member, options.ticks);
      },
      [&](auto& member, const auto& robot) { return joint_node::create_realtime(robot, options.joints, member); });
}
