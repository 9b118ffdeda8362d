// The trot on the three hosts of its deployment, in lock-step: whatever is between them, the trace is the same.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "deployed_robot.hpp"
#include "tests/support/frame_relay.hpp"
#include "tests/support/needs_network_namespaces.hpp"

namespace farrier::test {
namespace three_hosts_test {

using namespace std::chrono_literals;

const char* const kDuration = tested_duration("0.3");
const Tick kTicks = std::lround(std::atof(kDuration) * 1e3);

/// Trace of a run in one process, with the gains of the deployment.
const std::string& reference_trace() {
  static const std::string trace =
      trace_of_trot({"--dds", "inproc", "--design", "phases", "--duration", kDuration});
  return trace;
}

class ThreeHosts : public NeedsNetworkNamespaces<testing::TestWithParam<const char*>> {};

TEST_P(ThreeHosts, RunTheTrotInLockstepToTheSameTrace) {
  const DeployedRun run{.dds = GetParam(), .ticks = kTicks};
  const robot::Robot robot = deployed_robot(run);
  const NetworkNamespaces network = network_of(robot);
  DeployedProcesses processes(robot, network, run);
  ASSERT_EQ(processes.wait_for_trace(reference_trace().size(), 60s), "");
  EXPECT_EQ(processes.stop(), "");
  EXPECT_TRUE(read_file(processes.trace_path()) == reference_trace());
}

// Every datagram between the brain and a leg passes one bad cable, those of discovery, heartbeats and acknowledgements too.
TEST_P(ThreeHosts, RunTheTrotInLockstepToTheSameTraceOverBadCables) {
  const DeployedRun run{.dds = GetParam(), .ticks = kTicks};
  const robot::Robot robot = deployed_robot(run);
  NetworkNamespaces network = network_of(robot);
  const Impairment bad{.loss = 0.05, .most = 1ms, .duplicate = 0.01, .reorder = 0.01};
  const FrameRelay front(network, "front", bad);
  const FrameRelay hind(network, "hind", bad);
  DeployedProcesses processes(robot, network, run);
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(processes.wait_for_trace(reference_trace().size(), 600s), "");
  const std::chrono::duration<double> lasted = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(processes.stop(), "");
  EXPECT_TRUE(read_file(processes.trace_path()) == reference_trace());
  const std::uint64_t packets = front.packets() + hind.packets();
  std::printf("%s: %.1f s, %lu of %lu packets lost\n", GetParam(), lasted.count(), front.lost() + hind.lost(), packets);
  EXPECT_GT(front.lost() + hind.lost(), packets / 25);
}

INSTANTIATE_TEST_SUITE_P(Over, ThreeHosts, testing::ValuesIn(tested_vendors("mixed")),
                         [](const auto& dds) { return std::string(dds.param); });

}  // namespace three_hosts_test
}  // namespace farrier::test
