// farrier faults and what it stands on, started as a user would: what runs in real time.

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>

#include "farrier_command.hpp"

namespace farrier::test {
namespace faults_command_test {

TEST(Faults, CutAJointsCommandsAndSeeItDampAndCatchItself) {
  const ScratchDirectory scratch;
  std::string output;
  run_farrier({"faults", "--rows", "command_cut_short", "--dds", "cyclone", "--cells", "1", "--out",
               scratch.file("out"), "--page", scratch.file("page.md")},
              &output);
  const nlohmann::json run = read_json(scratch.file("out/figures.json"));
  ASSERT_FALSE(run.is_discarded()) << output;
  EXPECT_EQ(figure(run, "faults.cells"), 1.0);
  // The rest depends on the computer as much as on the stack, and is not checked.
  EXPECT_GE(figure(run, "faults.command_cut_short.reaction_ms"), 4.0) << output;
  EXPECT_LE(figure(run, "faults.command_cut_short.reaction_ms"), 9.0) << output;
  EXPECT_LE(figure(run, "faults.command_cut_short.event_ms"), 9.0) << output;
  EXPECT_EQ(figure(run, "faults.command_cut_short.tripped_ms"), 0.0) << output;
  EXPECT_NE(read_file(scratch.file("page.md")).find("| `command_cut_short` |"), std::string::npos);
}

TEST(Faults, LetAWalkingRobotLoseTheImuForShortAndWalkOn) {
  const ScratchDirectory scratch;
  std::string output;
  run_farrier({"faults", "--world", "body", "--rows", "imu_cut_short", "--dds", "cyclone", "--cells", "1", "--slow",
               "1", "--repeats", "0", "--out", scratch.file("out"), "--page", scratch.file("page.md")},
              &output);
  const nlohmann::json run = read_json(scratch.file("out/figures.json"));
  ASSERT_FALSE(run.is_discarded()) << output;
  EXPECT_EQ(figure(run, "faults.cells"), 1.0);
  EXPECT_EQ(figure(run, "faults.repeats"), 0.0);
  EXPECT_EQ(figure(run, "faults.falls"), 0.0) << output;
  EXPECT_GT(figure(run, "faults.imu_cut_short.ground_force_N"), 500.0) << "a trot, which the fault does not end";
  EXPECT_LE(figure(run, "faults.imu_cut_short.acts_ms"), 1000.0) << output;
  // The times of the joints depend on the computer as much as on the stack, and are not checked.
  EXPECT_NE(read_file(scratch.file("page.md")).find("| `imu_cut_short` | may fall, on a ground only | 1 |"),
            std::string::npos);
}

TEST(Request, StopsARobotAndArmsItAgain) {
  const ScratchDirectory scratch;
  FarrierCommand trot({"trot", "--world", "bench", "--clock", "realtime", "--no-comparison", "--nodes", "one",
                       "--duration", "600", "--out", scratch.file("out")});
  ASSERT_TRUE(trot.says("trot: tick 0 of")) << trot.output();
  const pid_t supervisor = trot.process("supervisor");
  ASSERT_NE(supervisor, 0);
  std::string line = read_file("/proc/" + std::to_string(supervisor) + "/cmdline");
  std::replace(line.begin(), line.end(), '\0', ' ');
  const std::size_t place = line.find("--domain ") + std::string("--domain ").size();
  const std::string domain = line.substr(place, line.find(' ', place) - place);
  const std::string session = std::to_string(trot.pid());
  std::string output;
  EXPECT_EQ(run_farrier({"request", "stop", "--session", session, "--domain", domain}, &output), 0) << output;
  EXPECT_NE(output.find("hyq is stopped"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"request", "arm", "--session", session, "--domain", domain, "--dds", "fast"}, &output), 0)
      << output;
  EXPECT_NE(output.find("hyq is armed"), std::string::npos) << output;
  trot.signal(SIGINT);
  EXPECT_EQ(trot.wait(std::chrono::seconds(20)), 130);
}

}  // namespace faults_command_test
}  // namespace farrier::test
