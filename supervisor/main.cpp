// supervisor: clock/tick + joint/model_estimate ──▶ designs ──▶ joint/controller_gains, system/mode

#include "process/process.hpp"
#include "supervisor/ports.hpp"

int main(int argc, char** argv) {
  using namespace farrier;
  const auto options = participant::parse_options("supervisor", "Arms the robot and publishes its gains", argc, argv);
  return process::run(options, [&](auto& member, const auto& robot) {
    return supervisor::create_application(robot, supervisor::parse_design(options.design), member, options.ticks, options.standby);
  });
}
