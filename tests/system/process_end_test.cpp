// Ends of a run before its time: the launcher's messages, and the end of its processes.

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "farrier_command.hpp"

namespace farrier::test {
namespace process_end_test {

using namespace std::chrono_literals;

std::vector<std::string> long_trot(const ScratchDirectory& scratch, const std::string& dds = "cyclone",
                                   const std::string& duration = "3600") {
  return {"trot", "--world", "bench", "--dds", dds, "--duration", duration, "--out", scratch.file("out")};
}

bool all_gone(pid_t launcher) {
  for (int i = 0; i < 500 && !processes_of_session(launcher).empty(); ++i) {
    std::this_thread::sleep_for(10ms);
  }
  return processes_of_session(launcher).empty();
}

TEST(Termination, EndsTheRunWithStatus143AndLeavesNobodyBehind) {
  const ScratchDirectory scratch;
  FarrierCommand trot(long_trot(scratch));
  ASSERT_TRUE(trot.says("trot: tick 0 of"));
  trot.signal(SIGTERM);
  EXPECT_EQ(trot.wait(20s), 143);
  EXPECT_TRUE(all_gone(trot.pid()));
}

TEST(EarlyInterrupt, EndsARunThatHasHardlyBegun) {
  const ScratchDirectory scratch;
  FarrierCommand trot(long_trot(scratch, "fast"));
  ASSERT_NE(trot.process("sim_bridge"), 0);
  trot.signal(SIGINT);
  EXPECT_EQ(trot.wait(30s), 130);
  EXPECT_TRUE(all_gone(trot.pid()));
}

TEST(EarlyInterrupt, EndsARunInOneProcess) {
  const ScratchDirectory scratch;
  FarrierCommand trot(long_trot(scratch, "inproc"));
  ASSERT_TRUE(trot.says("trot: tick"));
  trot.signal(SIGINT);
  EXPECT_EQ(trot.wait(20s), 130);
}

TEST(EarlyInterrupt, EndsARunWithAStoppedProcess) {
  const ScratchDirectory scratch;
  FarrierCommand trot(long_trot(scratch));
  const pid_t stopped = trot.process("supervisor");
  ASSERT_NE(stopped, 0);
  ASSERT_TRUE(trot.says("trot: tick 0 of"));
  ASSERT_EQ(::kill(stopped, SIGSTOP), 0);
  trot.signal(SIGINT);
  EXPECT_EQ(trot.wait(20s), 130);
  EXPECT_TRUE(all_gone(trot.pid()));
}

TEST(StoppedProcess, IsNamedWithItsPidAndTheTickTheRunStandsAt) {
  const ScratchDirectory scratch;
  FarrierCommand trot(long_trot(scratch));
  const pid_t stopped = trot.process("sim_bridge");
  ASSERT_NE(stopped, 0);
  ASSERT_TRUE(trot.says("trot: tick 0 of"));
  std::this_thread::sleep_for(500ms);
  ASSERT_EQ(::kill(stopped, SIGSTOP), 0);
  EXPECT_TRUE(trot.says("stopped: sim_bridge (pid " + std::to_string(stopped) + "); the run stands at tick ", 30s))
      << trot.output();
}

TEST(KilledProcessInALog, IsQuotedWithItsLastWords) {
  const ScratchDirectory scratch;
  FarrierCommand trot(long_trot(scratch, "cyclone", "5"));
  const pid_t stopped = trot.process("sim_bridge");
  const pid_t killed = trot.process("joint_node_lh");
  ASSERT_NE(stopped, 0);
  ASSERT_NE(killed, 0);
  ASSERT_TRUE(trot.says("trot: tick 5"));  // a tenth of the run: everyone has begun
  ASSERT_EQ(::kill(stopped, SIGSTOP), 0);
  // By the time the launcher speaks of the standstill, the joint node has said in its log what it waits for.
  ASSERT_TRUE(trot.says("stopped: sim_bridge", 30s)) << trot.output();
  ASSERT_EQ(::kill(killed, SIGKILL), 0);
  EXPECT_EQ(trot.wait(20s), 1);
  const std::string output = trot.output();
  EXPECT_NE(output.find("joint_node_lh (pid " + std::to_string(killed) + ") ended with exit status 137"),
            std::string::npos)
      << output;
  EXPECT_NE(output.find("joint_node_lh: waiting for joint/sensors of lh_"), std::string::npos) << output;
  EXPECT_TRUE(all_gone(trot.pid()));
}

TEST(Launcher, OutlivesTheShellThatStartedIt) {
  const ScratchDirectory scratch;
  FarrierCommand shell({"-c", "\"$0\" trot --duration 1 --out \"$1\" & exit 0", FARRIER_COMMAND, scratch.file("out")},
                       {"/bin/sh", nullptr});
  EXPECT_EQ(shell.wait(20s), 0);
  EXPECT_TRUE(shell.says("figures: ")) << shell.output();
}

}  // namespace process_end_test
}  // namespace farrier::test
