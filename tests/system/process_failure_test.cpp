// A process that dies, stops or does not greet ends the run with its name; nobody is left behind.

#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <thread>

#include "farrier_command.hpp"

namespace farrier::test {
namespace process_failure_test {

using namespace std::chrono_literals;

/// Long enough to be interrupted, never meant to end by itself.
std::vector<std::string> long_trot(const ScratchDirectory& scratch, const std::string& clock = "lockstep",
                                   const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"trot", "--world", "bench", "--no-comparison", "--duration",
                                     "600",  "--clock", clock,   "--out",           scratch.file("out")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
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

TEST(PausedProcess, IsNamedWithTheTickItBlocks) {
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

constexpr auto kBeyondTheLimit = 4s;  // of 2 s

/// A run that says when a tenth of it, 0.5 s, is over.
std::vector<std::string> begun_trot(const ScratchDirectory& scratch, const std::string& stall_limit_s) {
  return {"trot", "--world", "bench", "--duration", "5", "--stall-limit", stall_limit_s, "--out", scratch.file("out")};
}

bool has_begun(const FarrierCommand& trot) { return trot.says("trot: tick 5"); }

std::string with_pid(const std::string& name, pid_t pid) { return name + " (pid " + std::to_string(pid) + ")"; }

TEST(StallLimit, EndsARunThatAStoppedProcessBlocks) {
  const ScratchDirectory scratch;
  FarrierCommand trot(begun_trot(scratch, "2"));
  const pid_t stopped = trot.process("joint_node_rf");
  ASSERT_NE(stopped, 0);
  ASSERT_TRUE(has_begun(trot));
  ASSERT_EQ(::kill(stopped, SIGSTOP), 0);
  EXPECT_EQ(trot.wait(20s), 1) << trot.output();
  EXPECT_NE(trot.output().find("no tick has begun for 2 s (--stall-limit); the run stands at tick "), std::string::npos)
      << trot.output();
  EXPECT_NE(trot.output().find(with_pid("joint_node_rf", stopped) + " is stopped"), std::string::npos) << trot.output();
  EXPECT_TRUE(all_gone(trot.pid()));
}

TEST(StallLimit, DoesNotCountWhileTheLauncherItselfIsStopped) {
  const ScratchDirectory scratch;
  FarrierCommand trot(long_trot(scratch, "lockstep", {"--stall-limit", "2"}));
  ASSERT_NE(trot.process("sim_bridge"), 0);
  ASSERT_TRUE(runs(trot));
  trot.renice(5);  // leaves processors to tests beside
  std::this_thread::sleep_for(500ms);
  trot.signal(SIGSTOP);
  std::this_thread::sleep_for(kBeyondTheLimit);
  trot.signal(SIGCONT);
  EXPECT_EQ(trot.wait(kBeyondTheLimit), -1) << trot.output();
  trot.signal(SIGINT);
  EXPECT_EQ(trot.wait(20s), 130);
  EXPECT_TRUE(all_gone(trot.pid()));
}

TEST(StallLimit, DoesNotCountWhileADebuggerIsAttached) {
  const ScratchDirectory scratch;
  FarrierCommand trot(begun_trot(scratch, "2"));
  const pid_t held = trot.process("supervisor");
  ASSERT_NE(held, 0);
  ASSERT_TRUE(has_begun(trot));
  if (::ptrace(PTRACE_SEIZE, held, nullptr, nullptr) != 0) {
    GTEST_SKIP() << "this computer does not allow debuggers: errno " << errno;
  }
  ASSERT_EQ(::ptrace(PTRACE_INTERRUPT, held, nullptr, nullptr), 0);
  ASSERT_EQ(::waitpid(held, nullptr, __WALL), held);
  EXPECT_EQ(trot.wait(kBeyondTheLimit), -1) << trot.output();
  EXPECT_TRUE(trot.says("stopped: supervisor", 10s)) << trot.output();
  ASSERT_EQ(::ptrace(PTRACE_DETACH, held, nullptr, nullptr), 0);
  ASSERT_EQ(::kill(held, SIGSTOP), 0);  // no debugger is attached now
  EXPECT_EQ(trot.wait(20s), 1) << trot.output();
  EXPECT_TRUE(all_gone(trot.pid()));
}

TEST(StallLimit, OfZeroLetsARunWait) {
  const ScratchDirectory scratch;
  FarrierCommand trot(begun_trot(scratch, "0"));
  const pid_t stopped = trot.process("joint_node_rf");
  ASSERT_NE(stopped, 0);
  ASSERT_TRUE(has_begun(trot));
  ASSERT_EQ(::kill(stopped, SIGSTOP), 0);
  EXPECT_EQ(trot.wait(kBeyondTheLimit), -1) << trot.output();
  trot.signal(SIGINT);
  EXPECT_EQ(trot.wait(20s), 130);
}

TEST(StallLimit, BelowZeroIsRefused) {
  std::string output;
  EXPECT_EQ(run_farrier({"trot", "--world", "bench", "--stall-limit", "-1"}, &output), 2);
  EXPECT_NE(output.find("--stall-limit"), std::string::npos) << output;
}

class StoppedAtTheStart : public testing::TestWithParam<const char*> {};

TEST_P(StoppedAtTheStart, EndsTheRunWithinTheStartLimit) {
  const ScratchDirectory scratch;
  FarrierCommand trot(long_trot(scratch, GetParam(), {"--start-limit", "2"}));
  const pid_t stopped = trot.process("supervisor");
  ASSERT_NE(stopped, 0);
  ASSERT_EQ(::kill(stopped, SIGSTOP), 0);
  EXPECT_EQ(trot.wait(20s), 1) << trot.output();
  EXPECT_NE(trot.output().find("the start is not complete after 2 s (--start-limit); missing:"), std::string::npos)
      << trot.output();
  EXPECT_NE(trot.output().find("supervisor"), std::string::npos) << trot.output();
  EXPECT_NE(trot.output().find(" is stopped"), std::string::npos) << trot.output();
  EXPECT_TRUE(all_gone(trot.pid()));
}

INSTANTIATE_TEST_SUITE_P(Of, StoppedAtTheStart, testing::Values("lockstep", "realtime"),
                         [](const auto& clock) { return std::string(clock.param); });

/// An installation whose locomotion is `script`.
class OtherGaitSource {
 public:
  explicit OtherGaitSource(const std::string& script) {
    namespace fs = std::filesystem;
    const fs::path build = fs::path(FARRIER_COMMAND).parent_path().parent_path();
    fs::create_directories(scratch_.file("bin"));
    fs::create_directories(scratch_.file("libexec/farrier"));
    fs::copy_file(FARRIER_COMMAND, command());  // it looks for the others beside itself
    fs::create_directory_symlink(build / "share", scratch_.file("share"));
    for (const auto& program : fs::directory_iterator(build / "libexec/farrier")) {
      if (program.path().filename() != "locomotion") {
        fs::create_symlink(program.path(), fs::path(scratch_.file("libexec/farrier")) / program.path().filename());
      }
    }
    const std::string path = scratch_.file("libexec/farrier/locomotion");
    std::ofstream(path) << "#!/bin/sh\n" << script << '\n';
    fs::permissions(path, fs::perms::owner_all);
  }

  std::string command() const { return scratch_.file("bin/farrier"); }

 private:
  ScratchDirectory scratch_;
};

TEST(StartLimit, EndsARunWithARunningProcessThatIsNotHeard) {
  const ScratchDirectory scratch;
  const OtherGaitSource other("echo busy with something else; exec sleep 600");
  // The others must have greeted by then, also on a slow computer.
  FarrierCommand trot(long_trot(scratch, "lockstep", {"--start-limit", "4"}), {other.command(), nullptr});
  EXPECT_EQ(trot.wait(20s), 1) << trot.output();
  const std::string log = scratch.file("out/log/locomotion.log");
  EXPECT_NE(trot.output().find("locomotion (pid "), std::string::npos) << trot.output();
  EXPECT_NE(trot.output().find(" runs and is not heard; its log " + log + " ends with: busy with something else"),
            std::string::npos)
      << trot.output();
  EXPECT_EQ(trot.output().find("supervisor"), std::string::npos) << trot.output();
  EXPECT_NE(trot.output().find("farrier doctor --domain "), std::string::npos) << trot.output();
  EXPECT_TRUE(all_gone(trot.pid()));
}

TEST(Start, OfAProcessThatEndsEndsTheRunWithItsLog) {
  const ScratchDirectory scratch;
  const OtherGaitSource other("echo no such gait; exit 3");
  FarrierCommand trot(long_trot(scratch), {other.command(), nullptr});
  EXPECT_EQ(trot.wait(20s), 1) << trot.output();
  EXPECT_NE(trot.output().find("ended with exit status 3; its log " + scratch.file("out/log/locomotion.log") +
                               " ends with:\n  no such gait"),
            std::string::npos)
      << trot.output();
  EXPECT_TRUE(all_gone(trot.pid()));
}

}  // namespace process_failure_test
}  // namespace farrier::test
