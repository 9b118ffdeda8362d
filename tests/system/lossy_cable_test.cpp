// The trot on three hosts in real time, in slow motion as farrier faults has it, over a cable that loses and delays.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "gait/schedule.hpp"
#include "robot_watch.hpp"
#include "tests/support/frame_relay.hpp"
#include "tests/support/needs_network_namespaces.hpp"
#include "report/trot/tracking.hpp"
#include "undisturbed.hpp"

namespace farrier::test {
namespace lossy_cable_test {

using namespace std::chrono_literals;

const Tick kTicks = std::lround(std::atof(tested_duration("3")) * 1e3);
/// On the robot's clock: up to a period.
constexpr Impairment kCable{.loss = 0.01, .most = kSlow * Nanoseconds(1ms)};

class LossyCable : public NeedsNetworkNamespaces<testing::TestWithParam<const char*>> {};

/// "0.05 to 0.07, 2 % not tracking": stance NRMSE of the joints of the front legs, lf and rf, or of the hind legs.
std::string stance_nrmse(const robot::Robot& robot, const report::Tracking& tracking, char end) {
  std::vector<double> errors;
  std::uint64_t judged = 0;
  std::uint64_t elsewhere = 0;
  for (const robot::Joint& joint : robot.joints) {
    if (robot.plan.legs[static_cast<std::size_t>(joint.leg)].name.ends_with(end)) {
      const report::JointTracking& of = tracking.joints[joint.number];
      errors.push_back(of.stance.nrmse);
      judged += of.stance.ticks + of.swing.ticks;
      elsewhere += of.not_tracking_ticks;
    }
  }
  const auto [least, most] = std::ranges::minmax(errors);
  char text[64];
  std::snprintf(text, sizeof text, "%.3f to %.3f, %.1f %% not tracking,", least, most,
                1e2 * static_cast<double>(elsewhere) / static_cast<double>(judged));
  return text;
}

TEST_P(LossyCable, TripsNoJoint) {
  expect_undisturbed([](cli::PauseWatch& pauses) -> std::string {
    const DeployedRun deployed = slow_run(GetParam());
    const robot::Robot robot = deployed_robot(deployed);
    NetworkNamespaces network = network_of(robot);
    const FrameRelay relay(network, "front", kCable);
    DeployedProcesses processes(robot, network, deployed);
    {
      const NetworkNamespaces::Visit visit(network, "brain");
      RobotWatch watch(robot, processes.options_of("supervisor"));
      watch.until(kStanding, kPatience);
      pauses.forget();
      EXPECT_GE(watch.until(kTicks, kPatience), kTicks) << processes.output();
    }
    const auto trace = trace_after(processes, robot);
    if (!trace) {
      return trace.error().message + "\n";
    }
    const gait::Schedule schedule(robot.plan, processes.options_of("sim_bridge").seed);
    const report::Tracking tracking = report::track(robot, schedule, trace.value(), robot.loop_delay_realtime);
    std::printf("%s: %lu of %lu packets lost, stance NRMSE %s in front, %s behind\n", GetParam(), relay.lost(),
                relay.packets(), stance_nrmse(robot, tracking, 'f').c_str(),
                stance_nrmse(robot, tracking, 'h').c_str());
    return std::ranges::any_of(tracking.joints, &report::JointTracking::tripped) ? "a joint trips\n" : "";
  });
}

INSTANTIATE_TEST_SUITE_P(Over, LossyCable, testing::ValuesIn(tested_vendors("mixed")),
                         [](const auto& dds) { return std::string(dds.param); });

}  // namespace lossy_cable_test
}  // namespace farrier::test
