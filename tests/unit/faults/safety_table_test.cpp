// The safety table of a joint, the robot file and the rows of `farrier faults` agree.

#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "core/fault.hpp"
#include "tests/unit/robot/test_files.hpp"
#include "tools/faults/fault_rows.hpp"

namespace farrier::faults {
namespace safety_table_test {

const robot::Robot& hyq() {
  static const robot::Robot robot = robot::load_shipped("hyq");
  return robot;
}

TEST(FaultRows, HaveTheLimitsOfTheShippedRobot) {
  const robot::Safety& limits = hyq().safety;
  const auto within = [](const char* row) { return find_row(row)->expected.within_s; };
  const double reach_s = within("sensors_nan");
  EXPECT_NEAR(within("sensors_cut"), limits.sensors_stale_s + reach_s, 1e-12);
  EXPECT_NEAR(within("sensors_frozen"), limits.frozen_samples * hyq().period_s + reach_s, 1e-12);
  EXPECT_NEAR(within("command_cut_short"), limits.command_damping_s + reach_s, 1e-12);
  EXPECT_NEAR(within("command_cut_long"), limits.command_trip_s + reach_s, 1e-12);
  EXPECT_NEAR(within("valve_cut"), limits.valve_silent_s + reach_s, 1e-12);
  EXPECT_NEAR(find_row("sensors_cut")->expected.recovers_s, limits.recovery_samples * hyq().period_s + reach_s, 1e-12);
}

TEST(SafetyTable, NamesOnlyLimitsOfTheRobotFile) {
  const std::string parameters = robot::parameter_table();
  static const std::regex limit("`([a-z]+(_[A-Za-z0-9]+)+)`");
  int found = 0;
  const std::string table = safety_table_markdown();
  for (auto one = std::sregex_iterator(table.begin(), table.end(), limit); one != std::sregex_iterator(); ++one) {
    const std::string name = (*one)[1];
    const bool is_limit = name != "sim_bridge" && name != "flow_inversion";
    EXPECT_TRUE(!is_limit || parameters.find("`safety." + name + "`") != std::string::npos) << name;
    found += is_limit ? 1 : 0;
  }
  EXPECT_GT(found, 5);
}

}  // namespace safety_table_test
}  // namespace farrier::faults
