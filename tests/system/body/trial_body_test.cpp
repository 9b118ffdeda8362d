// farrier trial body, as a user runs it: whole robots on simulated ground.

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>

#include "tests/system/farrier_command.hpp"

namespace farrier::test {
namespace trial_body_test {

TEST(TrialBody, JudgesATrialAndTakesItsRunsOver) {
  const ScratchDirectory scratch;
  std::vector<std::string> arguments{"trial",           "body",  "--smoke",          "--only",
                                     "turning,payload", "--out", scratch.file("out")};
  std::string output;
  ASSERT_EQ(run_farrier(arguments, &output), 0) << output;
  EXPECT_NE(output.find("turning  1     0"), std::string::npos) << output;
  EXPECT_NE(output.find("trial: pass"), std::string::npos) << output;
  const auto json = read_json(scratch.file("out/figures.json"));
  EXPECT_EQ(json["command"], "trial");
  EXPECT_EQ(figure(json, "body.turning.falls"), 0.0);
  const std::string runs = read_file(scratch.file("out/runs.csv"));
  arguments.emplace_back("--continue");
  ASSERT_EQ(run_farrier(arguments, &output), 0) << output;
  EXPECT_NE(output.find("has 2 of 2 runs"), std::string::npos) << output;
  EXPECT_EQ(read_file(scratch.file("out/runs.csv")), runs);
}

TEST(TrialBody, StaysUprightInTheFirstRunsOfTrialsWithADisturbance) {
  const ScratchDirectory scratch;
  std::string output;
  const int status = run_farrier(
      {"trial", "body", "--smoke", "--only", "pushes,slopes,blocks,step", "--out", scratch.file("out")}, &output);
  EXPECT_EQ(status, 0) << output;
}

TEST(TrialBody, KeepsItsRunsWhenItIsInterrupted) {
  const ScratchDirectory scratch;
  FarrierCommand trial({"trial", "body", "--only", "pushes", "--out", scratch.file("out")});
  ASSERT_TRUE(trial.says("trial body")) << trial.output();
  trial.signal(SIGINT);
  EXPECT_EQ(trial.wait(std::chrono::seconds(20)), 128 + SIGINT) << trial.output();
  EXPECT_NE(trial.output().find("the same with --continue goes on from"), std::string::npos) << trial.output();
  EXPECT_TRUE(std::filesystem::exists(scratch.file("out/figures.json.runs")));
  EXPECT_EQ(read_json(scratch.file("out/figures.json"))["verdict"], "fail");
}

TEST(TrialBody, RefusesOptionsOfTheOtherTrialAndRobotsThatCannotWalk) {
  const ScratchDirectory scratch;
  std::string output;
  EXPECT_EQ(run_farrier({"trial", "body", "--hide", "1", "--out", scratch.file("out")}, &output), 2);
  EXPECT_NE(output.find("--hide is for farrier trial hide"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"trial", "--only", "flat", "--out", scratch.file("out")}, &output), 2);
  EXPECT_NE(output.find("--only is for farrier trial body"), std::string::npos) << output;
  const std::string rig = std::string(FARRIER_ROBOTS) + "/fc1d.yaml";
  EXPECT_EQ(run_farrier({"trial", "body", "--robot", rig, "--out", scratch.file("out")}, &output), 2);
  EXPECT_NE(output.find("fc1d cannot walk on a ground"), std::string::npos) << output;
}

}  // namespace trial_body_test
}  // namespace farrier::test
