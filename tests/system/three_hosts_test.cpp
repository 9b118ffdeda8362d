// The trot on the three hosts of its deployment, in lock-step: whatever is between them, the trace is the same.

#include <gtest/gtest.h>

#include "deployed_robot.hpp"

namespace farrier::test {
namespace {

using namespace std::chrono_literals;

constexpr const char* kDuration = "1";
constexpr Tick kTicks = 1000;

/// Of a run in one process, with the gains of the deployment.
const std::string& reference_trace() {
  static const std::string trace = [] {
    const ScratchDirectory scratch;
    std::string output;
    run_farrier({"trot", "--dds", "inproc", "--design", "phases", "--duration", kDuration, "--out", scratch.file("out")},
                &output);
    std::string text = read_file(scratch.file("out/trace.csv"));
    EXPECT_FALSE(text.empty()) << output;
    return text;
  }();
  return trace;
}

class ThreeHosts : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (const std::string refusal = NetworkNamespaces::refusal(); !refusal.empty()) {
      GTEST_SKIP() << refusal;
    }
  }
};

TEST_P(ThreeHosts, RunTheTrotInLockstepToTheSameTrace) {
  const DeployedRun run{.dds = GetParam(), .ticks = kTicks};
  const robot::Robot robot = deployed_robot(run);
  const NetworkNamespaces network = network_of(robot);
  DeployedProcesses processes(robot, network, run);
  ASSERT_EQ(processes.wait_for_trace(reference_trace().size(), 60s), "");
  EXPECT_EQ(processes.stop(), "");
  EXPECT_TRUE(read_file(processes.trace_path()) == reference_trace());
}

INSTANTIATE_TEST_SUITE_P(Over, ThreeHosts, testing::Values("cyclone", "fast", "mixed"),
                         [](const auto& dds) { return std::string(dds.param); });

}  // namespace
}  // namespace farrier::test
