// farrier diagnose --units scaled, as a user runs it: on a measured arm, on one that never was, and on what it must
// refuse.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "farrier_command.hpp"

namespace farrier::test {
namespace diagnose_scaled_test {

namespace fs = std::filesystem;

/// Least fit of the measured arm's second half, %.
constexpr double kArmFit_percent = 80.0;

/// The folder of the measured arm, which the repository does not have; empty where FARRIER_ARM_DATA names none.
fs::path arm_data() {
  const char* const given = std::getenv("FARRIER_ARM_DATA");
  return given != nullptr ? fs::path(given) : fs::path();
}

/// An arm whose valve's flow saturates at 0.4, in a file; `row` has its say about every line.
template <class Row>
void write_arm(const std::string& path, int samples, Row row) {
  std::ofstream file(path);
  file << "sample,valve,position\n";
  double position = 0.0;
  for (int k = 0; k < samples; ++k) {
    const double valve = 0.9 * std::sin(0.05 * k) * (1.0 + 0.6 * std::sin(0.0113 * k));
    file << row(k, std::to_string(k) + "," + std::to_string(valve) + "," + std::to_string(position)) << "\n";
    position += 0.05 * valve / std::hypot(1.0, valve / 0.4) + 0.001;
  }
}

std::string as_it_is(int, const std::string& line) { return line; }

nlohmann::json candidate(const nlohmann::json& json, const std::string& name) {
  const auto found = std::ranges::find_if(json["candidates"], [&](const auto& one) { return one["name"] == name; });
  return found == json["candidates"].end() ? nlohmann::json() : *found;
}

TEST(DiagnoseScaled, AMeasuredHydraulicArmHasAFlowThatSaturatesAndNoDeadband) {
  const fs::path recording = arm_data() / "hydraulic_arm.csv";
  if (!fs::exists(recording)) {
    GTEST_SKIP() << "the measured arm is not here: " << recording << "; FARRIER_ARM_DATA names its folder";
  }
  const ScratchDirectory scratch;
  std::string output;
  ASSERT_EQ(run_farrier({"diagnose", recording.string(), "--units", "scaled", "--out", scratch.file("out")}, &output),
            0)
      << output;
  const auto json = read_json(scratch.file("out/figures.json"));
  const auto named = std::ranges::find_if(json["effects"], [](const auto& one) {
    return one["name"] == "flow_saturation";
  });
  ASSERT_NE(named, json["effects"].end()) << output;
  EXPECT_NEAR((*named)["value"].get<double>(), 0.45, 0.1);
  EXPECT_FALSE(candidate(json, "valve_deadband")["accepted"].get<bool>()) << output;
  EXPECT_NEAR(candidate(json, "valve_deadband")["value"].get<double>(), 0.0, 0.01);
  EXPECT_LT(figure(json, "diagnose.fit_before_percent"), 0.0);
  EXPECT_GE(figure(json, "diagnose.fit_after_percent"), kArmFit_percent) << output;
  EXPECT_TRUE(fs::exists(scratch.file("out/pictures/position.svg")));
}

TEST(DiagnoseScaled, NamesASaturationWhateverTheThreads) {
  const ScratchDirectory scratch;
  write_arm(scratch.file("arm.csv"), 1000, as_it_is);
  nlohmann::json first;
  for (const char* threads : {"1", "3"}) {
    std::string output;
    ASSERT_EQ(run_farrier({"diagnose", scratch.file("arm.csv"), "--units", "scaled", "--json", scratch.file("a.json"),
                           "--threads", threads},
                          &output),
              0)
        << output;
    EXPECT_NE(output.find("diagnose: effects"), std::string::npos) << output;
    auto json = read_json(scratch.file("a.json"));
    EXPECT_EQ(json["effects"][0]["name"], "flow_saturation") << output;
    EXPECT_NEAR(json["effects"][0]["value"].get<double>(), 0.4, 0.01) << output;
    json.erase("run");
    EXPECT_TRUE(first.is_null() || first == json);
    first = json;
  }
}

TEST(DiagnoseScaled, RefusesBadDataWithItsRowsAndStillWritesThem) {
  const ScratchDirectory scratch;
  write_arm(scratch.file("arm.csv"), 1000,
            [](int k, const std::string& line) { return k == 300 ? std::string("300,0.1,nan") : line; });
  std::string output;
  EXPECT_EQ(run_farrier({"diagnose", scratch.file("arm.csv"), "--units", "scaled", "--out", scratch.file("out")},
                        &output),
            2);
  EXPECT_NE(output.find("arm.csv:302:"), std::string::npos) << output;
  const auto json = read_json(scratch.file("out/figures.json"));
  EXPECT_EQ(json["verdict"], "bad_data");
  EXPECT_EQ(json["findings"][0]["what"], "nan");
  EXPECT_EQ(json["findings"][0]["row"], 302);
}

TEST(DiagnoseScaled, RefusesWhatDataWithoutUnitsCannotHave) {
  const ScratchDirectory scratch;
  write_arm(scratch.file("arm.csv"), 1000, as_it_is);
  const auto refused = [&](std::vector<std::string> more, const std::string& word) {
    std::vector<std::string> arguments{"diagnose", scratch.file("arm.csv"), "--units", "scaled"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    std::string output;
    EXPECT_EQ(run_farrier(arguments, &output), 2) << output;
    EXPECT_NE(output.find(word), std::string::npos) << output;
  };
  refused({"--model", "fc1d.yaml"}, "--model is of a machine in SI units");
  refused({"--joint", "lf_kfe"}, "--joint is of a machine in SI units");
  refused({"--benchmark"}, "--benchmark makes recordings in SI units");
  std::string output;
  EXPECT_EQ(run_farrier({"diagnose", "--units", "scaled"}, &output), 2);
  EXPECT_NE(output.find("name a recording"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"diagnose", scratch.file("arm.csv"), "--units", "imperial"}, &output), 2);
  EXPECT_NE(output.find("si|scaled"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"diagnose", scratch.file("arm.csv")}, &output), 2);
  EXPECT_NE(output.find("--model"), std::string::npos) << output;
}

TEST(DiagnoseScaled, LeavesNoFilesWhenItIsInterrupted) {
  const ScratchDirectory scratch;
  write_arm(scratch.file("arm.csv"), 400'000, as_it_is);
  FarrierCommand command(
      {"diagnose", scratch.file("arm.csv"), "--units", "scaled", "--out", scratch.file("out")});
  ASSERT_TRUE(command.says("diagnose: percent")) << command.output();
  command.signal(SIGINT);
  EXPECT_EQ(command.wait(std::chrono::seconds(20)), 130) << command.output();
  EXPECT_NE(command.output().find("nothing was written"), std::string::npos) << command.output();
  EXPECT_TRUE(fs::is_empty(scratch.file("out")));
}

TEST(DiagnoseScaled, NeverWritesOverWhatItReads) {
  const ScratchDirectory scratch;
  write_arm(scratch.file("figures.json"), 1000, as_it_is);
  const std::string before = read_file(scratch.file("figures.json"));
  std::string output;
  EXPECT_EQ(run_farrier({"diagnose", scratch.file("figures.json"), "--units", "scaled", "--out", scratch.file("")},
                        &output),
            2);
  EXPECT_NE(output.find("is what is read"), std::string::npos) << output;
  EXPECT_EQ(read_file(scratch.file("figures.json")), before);
}

}  // namespace diagnose_scaled_test
}  // namespace farrier::test
