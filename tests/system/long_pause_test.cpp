// A debugger may hold a process longer than DDS waits for a silent one.

#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include "farrier_command.hpp"

namespace farrier::test {
namespace long_pause_test {

using namespace std::chrono_literals;

constexpr const char* kDuration = "1.5";
constexpr auto kLongerThanAnyLease = 25s;  // Cyclone's is 10 s unless told, Fast's 20 s

struct Pause {
  const char* dds;
  const char* process;
};

class LongPause : public testing::TestWithParam<Pause> {};

TEST_P(LongPause, ChangesNothing) {
  const ScratchDirectory scratch;
  run_farrier(
      {"trot", "--world", "bench", "--dds", "inproc", "--duration", kDuration, "--out", scratch.file("in_process")});
  FarrierCommand trot({"trot", "--world", "bench", "--dds", GetParam().dds, "--duration", kDuration, "--stall-limit",
                       "0", "--out", scratch.file("out")});
  const std::string name = GetParam().process;
  const pid_t paused = name == "farrier" ? trot.pid() : trot.process(name);
  ASSERT_NE(paused, 0);
  ASSERT_TRUE(trot.says("trot: tick 1") || trot.says("trot: tick 2"));
  ASSERT_EQ(::kill(paused, SIGSTOP), 0);
  std::this_thread::sleep_for(kLongerThanAnyLease);
  ASSERT_EQ(::kill(paused, SIGCONT), 0);
  EXPECT_NE(trot.wait(60s), -1) << trot.output();
  const std::string expected = read_file(scratch.file("in_process/trace.csv"));
  ASSERT_FALSE(expected.empty());
  EXPECT_TRUE(read_file(scratch.file("out/trace.csv")) == expected);
}

INSTANTIATE_TEST_SUITE_P(Of, LongPause,
                         testing::Values(Pause{"cyclone", "joint_node_lf"}, Pause{"cyclone", "sim_bridge"},
                                         Pause{"cyclone", "farrier"}, Pause{"fast", "joint_node_lf"},
                                         Pause{"fast", "sim_bridge"}, Pause{"fast", "estimator_service"},
                                         Pause{"fast", "supervisor"}, Pause{"mixed", "joint_node_lf"},
                                         Pause{"mixed", "sim_bridge"}),
                         [](const auto& pause) { return std::string(pause.param.dds) + "_" + pause.param.process; });

}  // namespace long_pause_test
}  // namespace farrier::test
