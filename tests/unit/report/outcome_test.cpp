#include <filesystem>
#include <limits>

#include <nlohmann/json.hpp>

#include "run.hpp"
#include "signals/signals.hpp"
#include "report/figures/console.hpp"
#include "report/trot/joint_poles.hpp"
#include "report/figures/outcome.hpp"
#include "tests/support/scratch_directory.hpp"

namespace farrier::report {
namespace outcome_test {

using testing::hyq;

ProcessInfo sim_bridge() {
  signals::SystemHello hello;
  hello.participant = 3;
  hello.pid = 4711;
  hello.vendor = 1;
  signals::assign(hello.name, "sim_bridge");
  signals::SystemHealth health;
  health.latency_s = {120e-6, 310e-6, 500e-6, 900e-6};
  health.sent[0] = 24000;      // joint/sensors
  health.received[2] = 23990;  // joint/valve_command
  health.lost[2] = 10;
  return process_info(hello, health);
}

Outcome outcome_with(double nrmse) {
  Outcome outcome{.command = "trot", .figures = {}, .run = run_info(hyq(), 42), .failures = {}};
  outcome.run.processes = {sim_bridge()};
  outcome.figures.add("trot.lf_kfe.stance_nrmse", nrmse, 0.1);
  outcome.figures.add("trot.lf_kfe.swing_nrmse", 0.02);
  outcome.figures.add("trot.lf_kfe.swing_design_stance_nrmse", 0.31);
  return outcome;
}

std::string last_line(const std::string& text) {
  const std::size_t before = text.find_last_of('\n', text.size() - 2);
  return text.substr(before + 1, text.size() - before - 2);
}

TEST(OutcomeJson, HasTheFormOfEveryCommand) {
  const auto json = nlohmann::json::parse(to_json(outcome_with(0.043)));
  EXPECT_EQ(json["command"], "trot");
  EXPECT_EQ(json["verdict"], "pass");
  EXPECT_EQ(json["figures"][0], nlohmann::json::parse(R"({"name": "trot.lf_kfe.stance_nrmse", "value": 0.043,
                                "unit": "1", "relation": "<=", "bound": 0.1, "holds": true})"));
  EXPECT_EQ(json["figures"][1], nlohmann::json::parse(R"({"name": "trot.lf_kfe.swing_nrmse", "value": 0.02,
                                "unit": "1"})"));
  for (const char* key : {"version", "git_revision", "configuration", "configuration_hash", "seed", "machine",
                          "processes"}) {
    EXPECT_TRUE(json["run"].contains(key)) << key;
  }
  EXPECT_EQ(json["run"]["seed"], 42);
  EXPECT_GE(json["run"]["machine"]["cores"], 1);
  EXPECT_FALSE(json.contains("failures"));
}

TEST(OutcomeJson, NamesTheProcessesWithTheirSamples) {
  const auto process = nlohmann::json::parse(to_json(outcome_with(0.043)))["run"]["processes"][0];
  EXPECT_EQ(process["name"], "sim_bridge");
  EXPECT_EQ(process["number"], 3);
  EXPECT_EQ(process["pid"], 4711);
  EXPECT_EQ(process["vendor"], "cyclone");
  EXPECT_EQ(process["topics"], nlohmann::json::parse(R"([
      {"topic": "joint/sensors", "sent": 24000, "received": 0, "lost": 0},
      {"topic": "joint/valve_command", "sent": 0, "received": 23990, "lost": 10}])"));
}

TEST(OutcomeJson, AValueThatIsNotANumberIsNullAndFails) {
  const auto json = nlohmann::json::parse(to_json(outcome_with(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(json["figures"][0]["value"].is_null());
  EXPECT_EQ(json["figures"][0]["holds"], false);
  EXPECT_EQ(json["verdict"], "fail");
}

TEST(OutcomeJson, AFailureBesidesFiguresFailsAndIsToldByName) {
  Outcome outcome = outcome_with(0.043);
  outcome.failures = {"joint_node_lf ended with status 1"};
  const auto json = nlohmann::json::parse(to_json(outcome));
  EXPECT_EQ(json["verdict"], "fail");
  EXPECT_EQ(json["failures"][0], "joint_node_lf ended with status 1");
}

TEST(OutcomeJson, ConfigurationThatIsNoUtf8StillMakesJson) {
  Outcome outcome = outcome_with(0.043);
  outcome.run.configuration = "name: \xff\xfe";
  EXPECT_TRUE(nlohmann::json::accept(to_json(outcome)));
}

TEST(OutcomeJson, RefusesAPathThatCannotBeWritten) {
  const auto written = write_json("/nonexistent/figures.json", outcome_with(0.043));
  ASSERT_FALSE(written.ok());
  EXPECT_NE(written.error().message.find("/nonexistent/figures.json"), std::string::npos);
}

TEST(OutcomeJson, ReplacesItsFileWholeOrNotAtAll) {
  const test::ScratchDirectory scratch;
  const std::string path = scratch.file("figures.json");
  ASSERT_TRUE(write_json(path, outcome_with(0.043)).ok());
  const auto size = std::filesystem::file_size(path);
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
  std::filesystem::create_directory(path + ".part");  // so that nothing can be written there
  Outcome longer = outcome_with(0.05);
  longer.failures = {"joint_node_lf ended with status 1"};
  EXPECT_FALSE(write_json(path, longer).ok());
  EXPECT_EQ(std::filesystem::file_size(path), size) << "the earlier one is as it was";
}

TEST(Transport, BecomesFiguresByProcessAndTopic) {
  Outcome outcome = outcome_with(0.043);
  add_transport(outcome.figures, outcome.run, true);
  EXPECT_EQ(outcome.figures.find("trot.packets.sim_bridge.joint_sensors.sent")->value, 24000.0);
  EXPECT_EQ(outcome.figures.find("trot.packets.sim_bridge.joint_valve_command.received")->value, 23990.0);
  EXPECT_NEAR(outcome.figures.find("trot.latency_p99_us")->value, 310.0, 1e-9);
  EXPECT_FALSE(outcome.figures.find("trot.lost_samples")->holds());
}

TEST(Transport, LossesAreOnlyCountedWhereTheyAreNotJudged) {
  Outcome outcome = outcome_with(0.043);
  add_transport(outcome.figures, outcome.run, false);
  EXPECT_EQ(outcome.figures.find("trot.lost_samples")->value, 10.0);
  EXPECT_TRUE(outcome.passes());
}

TEST(SpectralRadii, OfHyqAreBelowOneWithTheDelayOfLockStep) {
  const robot::Robot robot = hyq();
  Figures figures;
  ASSERT_TRUE(add_spectral_radii(figures, robot, robot.loop_delay_lockstep).ok());
  EXPECT_EQ(figures.all().size(), 2 * robot.joints.size());
  EXPECT_TRUE(figures.all_hold());
}

TEST(Console, EndsWithTheVerdict) {
  EXPECT_EQ(last_line(console_text(outcome_with(0.043), false)), "trot: pass");
  EXPECT_EQ(last_line(console_text(outcome_with(0.2), false)), "trot: fail");
}

TEST(Console, MarksAndExplainsABoundThatFails) {
  const std::string text = console_text(outcome_with(0.2), false);
  EXPECT_NE(text.find("0.2 !"), std::string::npos) << text;
  EXPECT_NE(text.find("! trot.lf_kfe.stance_nrmse 0.2, must be <= 0.1"), std::string::npos) << text;
  EXPECT_EQ(console_text(outcome_with(0.043), false).find('!'), std::string::npos);
}

TEST(Console, ShowsTheSwingDesignBesideAndEveryProcess) {
  const std::string text = console_text(outcome_with(0.043), false);
  EXPECT_NE(text.find("0.31"), std::string::npos) << text;
  EXPECT_NE(text.find("sim_bridge  pid 4711  cyclone  joint/sensors 24000 out"), std::string::npos) << text;
  EXPECT_NE(text.find("joint/valve_command 23990 in (10 lost)"), std::string::npos) << text;
}

TEST(Console, HasEscapeSequencesOnlyInColour) {
  EXPECT_EQ(console_text(outcome_with(0.2), false).find('\033'), std::string::npos);
  EXPECT_NE(console_text(outcome_with(0.2), true).find('\033'), std::string::npos);
}

}  // namespace outcome_test
}  // namespace farrier::report
