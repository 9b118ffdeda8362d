// Other robots through the same processes: each trots over both vendors at once as it does in process.

#include <gtest/gtest.h>

#include "farrier_command.hpp"

namespace farrier::test {
namespace robots_system_test {

std::string shipped(const std::string& name) { return std::string(FARRIER_ROBOTS) + "/" + name + ".yaml"; }

class OtherRobot : public testing::TestWithParam<const char*> {};

TEST_P(OtherRobot, TrotsOverBothVendorsAsItDoesInProcess) {
  const auto trace_over = [](const char* dds) {
    return trace_of_trot({"--robot", shipped(GetParam()), "--duration", "1.5", "--dds", dds});
  };
  const std::string alone = trace_over("inproc");
  ASSERT_GT(alone.size(), 1000u);
  EXPECT_TRUE(trace_over("mixed") == alone);
}

INSTANTIATE_TEST_SUITE_P(Shipped, OtherRobot, testing::Values("hexapod", "electric_leg"),
                         [](const auto& robot) { return std::string(robot.param); });

struct Misuse {
  const char* name;
  std::vector<std::string> arguments;
  const char* problem;
};

class ElectricLegMisused : public testing::TestWithParam<Misuse> {};

TEST_P(ElectricLegMisused, IsRefusedWithThePlaceAndTheRemedy) {
  const ScratchDirectory scratch;
  std::vector<std::string> arguments = GetParam().arguments;
  arguments.insert(arguments.end(), {"--robot", shipped("electric_leg"), "--out", scratch.file("out")});
  std::string output;
  EXPECT_EQ(run_farrier(arguments, &output), 2);
  EXPECT_NE(output.find(GetParam().problem), std::string::npos) << output;
}

INSTANTIATE_TEST_SUITE_P(
    By, ElectricLegMisused,
    testing::Values(Misuse{"controller",
                           {"trot", "--controller", "flow_inversion"},
                           "joints.haa.controller: torque is of kind flow_inversion, which inverts the flow of oil: an "
                           "electric joint takes lqr or pid"},
                    Misuse{
                        "compare", {"compare", "varied"}, "comparisons are of hydraulic joints, and haa is electric"},
                    Misuse{"trial", {"trial"}, "the effect is hidden in a hydraulic joint, and haa is electric"}),
    [](const auto& misuse) { return std::string(misuse.param.name); });

}  // namespace robots_system_test
}  // namespace farrier::test
