// A process that dies ends the run with its name; nobody is left behind.

#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include "farrier_command.hpp"

namespace farrier::test {
namespace {

using namespace std::chrono_literals;

/// Long enough to be interrupted, never meant to end by itself.
std::vector<std::string> long_trot(const ScratchDirectory& scratch, const std::string& clock = "lockstep") {
  return {"trot", "--duration", "600", "--clock", clock, "--out", scratch.file("out")};
}

/// True when no node process of the run is left within a generous time.
bool all_gone(pid_t launcher) {
  for (int i = 0; i < 500; ++i) {
    if (processes_of_session(launcher).empty()) {
      return true;
    }
    std::this_thread::sleep_for(10ms);
  }
  return false;
}

bool runs(const FarrierCommand& trot) { return trot.says("trot: tick 0 of"); }

class KilledProcess : public testing::TestWithParam<const char*> {};

TEST_P(KilledProcess, EndsTheRunWithItsNameAndLeavesNobodyBehind) {
  const ScratchDirectory scratch;
  FarrierCommand trot(long_trot(scratch));
  const pid_t victim = trot.process(GetParam());
  ASSERT_NE(victim, 0);
  ASSERT_TRUE(runs(trot));
  std::this_thread::sleep_for(500ms);
  ASSERT_EQ(::kill(victim, SIGKILL), 0);
  EXPECT_EQ(trot.wait(20s), 1);
  EXPECT_NE(trot.output().find(GetParam()), std::string::npos) << trot.output();
  EXPECT_NE(trot.output().find("137"), std::string::npos) << trot.output();
  EXPECT_TRUE(all_gone(trot.pid()));
}

INSTANTIATE_TEST_SUITE_P(Of, KilledProcess,
                         testing::Values("sim_bridge", "estimator_service", "supervisor", "joint_node_lf"),
                         [](const auto& name) { return std::string(name.param); });

TEST(Interrupt, EndsTheRunWithStatus130AndLeavesNobodyBehind) {
  const ScratchDirectory scratch;
  FarrierCommand trot(long_trot(scratch));
  ASSERT_TRUE(runs(trot));
  trot.signal(SIGINT);
  EXPECT_EQ(trot.wait(20s), 130);
  EXPECT_TRUE(all_gone(trot.pid()));
}

TEST(Interrupt, EndsARunOnTheRealTimeClockToo) {
  const ScratchDirectory scratch;
  FarrierCommand trot(long_trot(scratch, "realtime"));
  ASSERT_TRUE(runs(trot));
  std::this_thread::sleep_for(1s);
  trot.signal(SIGINT);
  EXPECT_EQ(trot.wait(20s), 130);
  EXPECT_TRUE(all_gone(trot.pid()));
}

TEST(KilledLauncher, TakesItsProcessesWithIt) {
  const ScratchDirectory scratch;
  FarrierCommand trot(long_trot(scratch));
  ASSERT_NE(trot.process("joint_node_rh"), 0);
  ASSERT_TRUE(runs(trot));
  trot.signal(SIGKILL);
  EXPECT_EQ(trot.wait(10s), 137);
  EXPECT_TRUE(all_gone(trot.pid()));
}

TEST(PausedProcess, IsNamedWithTheTickItHoldsUp) {
  const ScratchDirectory scratch;
  FarrierCommand trot(long_trot(scratch));
  const pid_t paused = trot.process("joint_node_lh");
  ASSERT_NE(paused, 0);
  ASSERT_TRUE(runs(trot));
  std::this_thread::sleep_for(500ms);
  ASSERT_EQ(::kill(paused, SIGSTOP), 0);
  EXPECT_TRUE(trot.says("stopped: joint_node_lh", 30s)) << trot.output();
  EXPECT_NE(trot.output().find("the run stands at tick"), std::string::npos);
  trot.signal(SIGINT);
  EXPECT_EQ(trot.wait(20s), 130);
  EXPECT_TRUE(all_gone(trot.pid()));
}

}  // namespace
}  // namespace farrier::test
