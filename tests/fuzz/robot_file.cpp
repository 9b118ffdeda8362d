// Robot files as people write them.

#include "robot/robot.hpp"
#include "tests/fuzz/harness.hpp"

namespace farrier::fuzz {

void robot_file(Bytes bytes) {
  const auto loaded = robot::load_robot_text(std::string(text_of(bytes)), "fuzz.yaml");
  if (!loaded) {
    require(!loaded.error().empty(), "a refusal says why");
    return;
  }
  const std::string printed = robot::print_config(loaded.value());
  const auto again = robot::load_robot_text(printed, "printed.yaml");
  require(again.ok() && robot::print_config(again.value()) == printed, "a robot as text is read as the same robot");
}

}  // namespace farrier::fuzz
