// supervisor: clock/tick + joint/model_estimate ──▶ designs ──▶ joint/controller_gains, system/mode

#include <cstdio>

#include "process/process.hpp"
#include "supervisor/ports.hpp"

int main(int argc, char** argv) {
  using namespace farrier;
  const auto options = participant::parse_options("supervisor", "Arms the robot and publishes its gains", argc, argv);
  const auto design = parse_choice("design", robot::kDesigns, options.design);
  if (!design) {
    std::fprintf(stderr, "supervisor: --design: %s\n", design.error().message.c_str());
    return 2;
  }
  return process::run(options, [&](auto& member, const auto& robot) {
    return supervisor::create_application(robot, design.value(), member, options.ticks, options.standby);
  });
}
