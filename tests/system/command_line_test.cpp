// Arguments that the command takes and refuses, and the files it writes.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "core/processes.hpp"
#include "farrier_command.hpp"

namespace farrier::test {
namespace command_line_test {

constexpr int kJointsPerLeg = 3;
constexpr int kTicks = 4000;

/// One run that the cases about figures share.
const nlohmann::json& figures_of_a_run() {
  static const nlohmann::json figures = [] {
    const ScratchDirectory scratch;
    const int status = run_farrier({"trot", "--world", "bench", "--design", "stance", "--dds", "mixed", "--duration",
                                    "4", "--out", scratch.file("out"), "--json", scratch.file("figures.json")});
    nlohmann::json json = read_json(scratch.file("figures.json"));
    json["exit_status"] = status;
    return json;
  }();
  return figures;
}

double figure_of_a_run(const std::string& name) { return figure(figures_of_a_run(), name); }

TEST(Figures, HaveTheCommonFormAndPass) {
  const nlohmann::json& run = figures_of_a_run();
  EXPECT_EQ(run["exit_status"], 0);
  EXPECT_EQ(run["command"], "trot");
  EXPECT_EQ(run["verdict"], "pass");
  for (const auto& entry : run["figures"]) {
    EXPECT_TRUE(entry.contains("name") && entry.contains("value") && entry.contains("unit")) << entry;
    EXPECT_EQ(entry.contains("bound"), entry.contains("relation")) << entry;
    EXPECT_EQ(entry.contains("bound"), entry.contains("holds")) << entry;
  }
  for (const char* part : {"version", "git_revision", "configuration", "seed", "machine", "processes"}) {
    EXPECT_TRUE(run["run"].contains(part)) << part;
  }
}

TEST(Figures, JudgeEveryJointInStanceWithTheSwingDesignBeside) {
  for (const char* leg : {"lf", "rf", "lh", "rh"}) {
    for (const char* joint : {"haa", "hfe", "kfe"}) {
      const std::string name = std::string("trot.") + leg + "_" + joint;
      EXPECT_LE(figure_of_a_run(name + ".stance_nrmse"), 0.10) << name;
      EXPECT_GT(figure_of_a_run(name + ".swing_design_stance_nrmse"), 0.0) << name;
    }
  }
}

TEST(Figures, ShowThatAProcessReceivesOnlyTheJointsItHosts) {
  EXPECT_EQ(figure_of_a_run("trot.packets.joint_node_lf.joint_sensors.received"), kJointsPerLeg * kTicks);
  // Locomotion works a tick ahead, and a node may take that tick's commands before it ends.
  EXPECT_GE(figure_of_a_run("trot.packets.joint_node_lf.joint_command.received"), kJointsPerLeg * kTicks);
  EXPECT_LE(figure_of_a_run("trot.packets.joint_node_lf.joint_command.received"), kJointsPerLeg * (kTicks + 1));
  EXPECT_EQ(figure_of_a_run("trot.packets.sim_bridge.joint_sensors.sent"), 4 * kJointsPerLeg * kTicks);
  EXPECT_EQ(figure_of_a_run("trot.packets.estimator_service.joint_measurement.received"), 4 * kJointsPerLeg * kTicks);
}

TEST(Figures, NameEveryProcessWithItsPidAndTheVendorItWasAskedFor) {
  std::set<int> pids;
  for (const auto& process : figures_of_a_run()["run"]["processes"]) {
    pids.insert(process["pid"].get<int>());
    const std::string name = process["name"];
    EXPECT_EQ(process["vendor"], name == "sim_bridge" || name == "estimator_service" ? "cyclone" : "fast") << name;
  }
  constexpr std::size_t kJointNodes = 4;
  EXPECT_EQ(pids.size(), kPrograms.size() - 1 + kJointNodes + 1) << "those of the robot and the launcher";
}

TEST(Figures, HoldTheLatencyFromSensorToValve) {
  EXPECT_GT(figure_of_a_run("trot.latency_p50_us"), 0.0);
  EXPECT_LE(figure_of_a_run("trot.latency_p50_us"), figure_of_a_run("trot.latency_p99_us"));
}

/// A robot file with these replacements, in a scratch directory.
class BadRobot {
 public:
  explicit BadRobot(std::initializer_list<std::pair<const char*, const char*>> replacements) {
    std::string text = read_file(FARRIER_ROBOTS "/hyq.yaml");
    for (const auto& [from, to] : replacements) {
      const std::size_t place = text.find(from);
      EXPECT_NE(place, std::string::npos) << from;
      text.replace(place, std::string(from).size(), to);
    }
    std::ofstream(path()) << text;
  }
  std::string path() const { return scratch_.file("bad.yaml"); }
  std::string out() const { return scratch_.file("out"); }

 private:
  ScratchDirectory scratch_;
};

TEST(BadInput, IsListedWholeWithItsLinesBeforeAnythingMoves) {
  const BadRobot robot({{"supply_pressure_Pa:", "supply_pressure_bar:"}, {"duty: 0.65", "duty: 1.7"}});
  std::string output;
  EXPECT_EQ(run_farrier({"trot", "--robot", robot.path(), "--out", robot.out()}, &output), 2);
  EXPECT_NE(output.find("supply_pressure_Pa"), std::string::npos) << output;
  EXPECT_NE(output.find("duty"), std::string::npos) << output;
  EXPECT_NE(output.find("bad.yaml:"), std::string::npos) << output;
  EXPECT_FALSE(std::filesystem::exists(robot.out()));
}

TEST(BadInput, NamesAFileThatIsNotThere) {
  std::string output;
  EXPECT_EQ(run_farrier({"trot", "--robot", "/nowhere/robot.yaml"}, &output), 2);
  EXPECT_NE(output.find("/nowhere/robot.yaml"), std::string::npos) << output;
}

TEST(BadInput, RefusesUnknownValuesOptionsAndCommandsByName) {
  std::string output;
  EXPECT_EQ(run_farrier({"trot", "--dds", "zenoh"}, &output), 2);
  EXPECT_NE(output.find("'zenoh' is not one of cyclone|fast|mixed|inproc"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"trot", "--duraton", "4"}, &output), 2);
  EXPECT_NE(output.find("--duraton"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"canter"}, &output), 2);
  EXPECT_NE(output.find("'canter' is not a farrier command"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"trot", "--world", "bench", "--clock", "realtime", "--dds", "inproc"}, &output), 2);
  EXPECT_EQ(run_farrier({"trot", "--design", "clever"}, &output), 2);
  EXPECT_NE(output.find("'clever' is not one of stance|swing|phases|adaptive"), std::string::npos) << output;
}

TEST(BadInput, OfAComparisonIsRefusedBeforeAnythingMoves) {
  const ScratchDirectory scratch;
  const std::string out = scratch.file("out");
  std::string output;
  EXPECT_EQ(run_farrier({"compare", "--out", out}, &output), 2);
  EXPECT_EQ(run_farrier({"compare", "gaits", "--out", out}, &output), 2);
  EXPECT_NE(output.find("'gaits' is not one of varied|controllers|update-logic|switching"), std::string::npos)
      << output;
  EXPECT_EQ(run_farrier({"compare", "varied", "--clock", "realtime", "--out", out}, &output), 2);
  EXPECT_EQ(run_farrier({"compare", "varied", "--seeds", "0", "--out", out}, &output), 2);
  EXPECT_NE(output.find("give 1 to 10000"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"trot", "--seeds", "3", "--out", out}, &output), 2);
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(BadInput, OfATrialIsRefusedBeforeAnythingMoves) {
  const ScratchDirectory scratch;
  const std::string out = scratch.file("out");
  std::string output;
  EXPECT_EQ(run_farrier({"trial", "--clock", "realtime", "--out", out}, &output), 2);
  EXPECT_EQ(run_farrier({"trial", "--hide", "-1", "--out", out}, &output), 2);
  EXPECT_EQ(run_farrier({"trial", "--hide", "knee", "--out", out}, &output), 2);
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(OldNames, SayTheNewOnesAndAreTaken) {
  struct Renamed {
    std::vector<std::string> old;
    const char* now;
  };
  const ScratchDirectory scratch;
  for (const Renamed& one : {Renamed{{"trot", "--vary"}, "this is now 'farrier compare varied'"},
                             Renamed{{"trot", "--experiment", "switching"}, "this is now 'farrier compare switching'"},
                             Renamed{{"trot", "--experiment", "fig7.8"}, "this is now 'farrier reproduce 7.8'"},
                             Renamed{{"trot", "--hide", "3"}, "this is now 'farrier trial --hide'"}}) {
    std::vector<std::string> arguments = one.old;
    arguments.insert(arguments.end(), {"--out", "/dev/null/out"});  // refused only once the rest has been taken
    std::string output;
    EXPECT_EQ(run_farrier(arguments, &output), 2);
    EXPECT_NE(output.find(one.now), std::string::npos) << output;
    EXPECT_NE(output.find("/dev/null"), std::string::npos) << output;
  }
}

TEST(VariedTrot, WritesARowForEverySeedControllerAndJointAndJudgesAdaptation) {
  constexpr int kControllers = 5;
  const ScratchDirectory scratch;
  const int status =
      run_farrier({"compare", "varied", "--seeds", "1", "--duration", "4", "--out", scratch.file("out")});
  const nlohmann::json run = read_json(scratch.file("out/figures.json"));
  EXPECT_EQ(status == 0, run["verdict"] == "pass");
  EXPECT_EQ(run["command"], "compare");
  std::set<std::string> bounded;
  for (const auto& entry : run["figures"]) {
    EXPECT_FALSE(entry["value"].is_null()) << entry;
    if (entry.contains("bound")) {
      bounded.insert(entry["name"].get<std::string>());
    }
  }
  EXPECT_EQ(bounded, (std::set<std::string>{"trot.vary.median_ratio_perfect", "trot.vary.adaptive_worst",
                                            "trot.vary.adaptive_diverged", "trot.vary.adaptive.seeds_failed"}));
  const std::string rows = read_file(scratch.file("out/vary.csv"));
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 1 + kControllers * 4 * kJointsPerLeg);
}

TEST(Design, DecidesWhoProbesAndWhetherGainsAreUpdated) {
  for (const char* design : {"adaptive", "stance", "swing", "phases"}) {
    const ScratchDirectory scratch;
    run_farrier({"trot", "--world", "bench", "--dds", "inproc", "--design", design, "--duration", "1.5", "--out",
                 scratch.file("out")});
    const nlohmann::json run = read_json(scratch.file("out/figures.json"))["run"];
    const bool adapts = std::string(design) == "adaptive";
    EXPECT_EQ(run["configuration"].get<std::string>().find("dither_percent: 0\n") == std::string::npos, adapts)
        << design;
    EXPECT_EQ(!run["decisions"].empty(), adapts) << design;
    EXPECT_EQ(read_file(scratch.file("out/events.txt")).find(" gains ") != std::string::npos, adapts) << design;
  }
}

TEST(Help, ListsTheCommandsAndTheOptionsOfEach) {
  std::string output;
  EXPECT_EQ(run_farrier({"--help"}, &output), 0);
  EXPECT_NE(output.find("usage: farrier <command>"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"trot", "--help"}, &output), 0);
  for (const char* option : {"--robot", "--dds", "--clock", "--nodes", "--duration", "--gait", "--frequency", "--seed",
                             "--out", "--trace", "--json", "--design", "--dither-cost"}) {
    EXPECT_NE(output.find(option), std::string::npos) << option;
  }
}

TEST(Version, SaysVersionAndRevisionOfThisBuild) {
  std::string output;
  EXPECT_EQ(run_farrier({"--version"}, &output), 0);
  EXPECT_EQ(output.find("farrier "), 0u) << output;
  EXPECT_NE(output.find("(git "), std::string::npos) << output;
}

}  // namespace command_line_test
}  // namespace farrier::test
