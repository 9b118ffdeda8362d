// Refusals of farrier faults, of processes with faults and of farrier request, and a request that no process answers.

#include <gtest/gtest.h>

#include "core/processes.hpp"
#include "farrier_command.hpp"

namespace farrier::test {
namespace faults_refusals_test {

TEST(FaultsCommand, RefusesRowsOfAnotherWorldAndMoreCellsThanThereAre) {
  const ScratchDirectory scratch;
  std::string output;
  const auto refuses = [&](std::vector<std::string> options, const std::string& words) {
    options.insert(options.begin(), {"faults", "--out", scratch.file("out")});
    EXPECT_EQ(run_farrier(options, &output), 2) << output;
    EXPECT_NE(output.find(words), std::string::npos) << output;
  };
  refuses({"--world", "body", "--rows", "gains_cut"}, "add --world bench");
  refuses({"--rows", "imu_cut_short"}, "add --world body");
  refuses({"--world", "ideal", "--rows", "supply_cut"}, "leave it out");
  refuses({"--rows", "sensors_cut", "--cells", "13"}, "have 12 cells: ask for no more");
  refuses({"--world", "body", "--robot", std::string(FARRIER_ROBOTS) + "/fc1d.yaml"},
          "fc1d cannot walk on a ground: give body.trunk and locomotion in its file");
}

TEST(FaultsCommand, RefusesUnknownRowsAndVendors) {
  const ScratchDirectory scratch;
  std::string output;
  EXPECT_EQ(run_farrier({"faults", "--rows", "sensors_gone", "--out", scratch.file("out")}, &output), 2);
  EXPECT_NE(output.find("no row is called 'sensors_gone': sensors_cut, "), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"faults", "--dds", "inproc", "--out", scratch.file("out")}, &output), 2);
}

TEST(FaultOptions, OfAProcessAreRefusedInLockstepAndWhenUnreadable) {
  std::string output;
  const std::vector<std::string> node{"--number", std::to_string(info(Program::kJointNode).number), "--participants",
                                      "9"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), node.begin(), node.end());
    return run_farrier(more, &output, {FARRIER_JOINT_NODE "_with_faults", {}});
  };
  EXPECT_EQ(with({"--fault", "joint/sensors:cut"}), 2);
  EXPECT_NE(output.find("in lock-step a lost sample holds the run up"), std::string::npos) << output;
  EXPECT_EQ(with({"--clock", "realtime", "--fault", "joint/sensor:cut"}), 2);
  EXPECT_NE(output.find("'joint/sensor' is no topic"), std::string::npos) << output;
}

TEST(FaultOptions, AreNoneOfAProgramThatShips) {
  std::string output;
  EXPECT_EQ(run_farrier({"--number", std::to_string(info(Program::kJointNode).number), "--participants", "9", "--clock",
                         "realtime", "--fault", "joint/sensors:cut"},
                        &output, {FARRIER_JOINT_NODE, {}}),
            2);
  EXPECT_NE(output.find("--fault"), std::string::npos) << output;
  EXPECT_EQ(output.find("TOPIC:KIND"), std::string::npos) << output;
}

TEST(RequestWithoutARobot, SaysWhereNobodyAnswers) {
  std::string output;
  EXPECT_EQ(run_farrier({"request", "arm", "--session", "7", "--domain", "231"}, &output), 1);
  EXPECT_NE(output.find("no supervisor of hyq, session 7, domain 231 answers"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"request", "dance", "--session", "7"}, &output), 2);
}

}  // namespace faults_refusals_test
}  // namespace farrier::test
