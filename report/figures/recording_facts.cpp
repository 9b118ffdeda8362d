#include "report/figures/recording_facts.hpp"

#include <charconv>

#include "bus/topics.hpp"
#include "report/figures/run_info.hpp"

namespace farrier::report {
namespace {

std::string hexadecimal(std::uint64_t number) {
  char text[17];
  return {text, std::to_chars(text, text + sizeof text, number, 16).ptr};
}

std::string shortest(double number) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

}  // namespace

mcap::Text recording_facts(const robot::Robot& robot) {
  const RunInfo info = run_info(robot, 0);
  return {{"robot", robot.name},
          {"configuration", info.configuration},
          {"configuration_hash", info.configuration_hash},
          {"period_s", shortest(robot.period_s)},
          {"version", info.version},
          {"git_revision", info.git_revision},
          {"contract", hexadecimal(bus::contract_hash())}};
}

}  // namespace farrier::report
