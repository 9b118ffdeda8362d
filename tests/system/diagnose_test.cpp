// farrier diagnose, as a user runs it: on what the simulation records, and on what it must refuse.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "farrier_command.hpp"

namespace farrier::test {
namespace diagnose_test {

namespace fs = std::filesystem;

std::string robot_file(const std::string& name) { return std::string(FARRIER_ROBOTS) + "/" + name; }

/// Two seconds of a joint that moves a little, in the columns of a recording; `row` has its say about every line.
template <class Row>
void write_recording(const std::string& path, Row row) {
  std::ofstream file(path);
  file << "time_s,valve_current_A,position_m,velocity_m_s,force_N\n";
  for (int i = 0; i < 2000; ++i) {
    const double t = 1e-3 * i;
    std::ostringstream line;
    line << t << "," << 0.003 * std::cos(10.0 * t) << "," << 0.04 + 0.01 * std::sin(10.0 * t) << ","
         << 0.1 * std::cos(10.0 * t) << "," << 50.0 * std::cos(10.0 * t);
    file << row(i, line.str()) << "\n";
  }
}

/// Trace of the rig in simulation, of a robot file.
std::string record(const ScratchDirectory& scratch, const std::string& robot, const char* duration) {
  const std::string trace = scratch.file("trace.csv");
  std::string output;
  const int status = run_farrier({"trot", "--world", "bench", "--robot", robot, "--dds", "inproc", "--design", "swing",
                                  "--duration", duration, "--out", scratch.file("trot"), "--trace", trace},
                                 &output);
  EXPECT_TRUE(status == 0 || status == 1) << output;
  return trace;
}

/// Returns the JSON of a diagnosis by the rig's model that refuses a file.
nlohmann::json refusal_of(const ScratchDirectory& scratch, const std::string& file, std::string& output) {
  const std::string json = scratch.file("found.json");
  EXPECT_EQ(run_farrier({"diagnose", file, "--model", robot_file("fc1d.yaml"), "--json", json}, &output), 2);
  return read_json(json);
}

TEST(Diagnose, OfTheSimulationByItsOwnModelFindsNothingMissing) {
  const ScratchDirectory scratch;
  const std::string trace = record(scratch, robot_file("fc1d.yaml"), "8");
  std::string output;
  const int status =
      run_farrier({"diagnose", trace, "--model", robot_file("fc1d.yaml"), "--out", scratch.file("out")}, &output);
  EXPECT_EQ(status, 0) << output;
  EXPECT_NE(output.find("diagnose: none"), std::string::npos) << output;
  const auto json = read_json(scratch.file("out/figures.json"));
  EXPECT_EQ(json["command"], "diagnose");
  EXPECT_EQ(json["verdict"], "none") << json["effects"];
  EXPECT_TRUE(json["extended_model"].is_null());
  EXPECT_GE(json["channels"].size(), 2u);
  EXPECT_TRUE(fs::exists(scratch.file("out/index.html")));
}

TEST(Diagnose, NamesADeadbandThatTheModelLacksAndTheExtendedModelLoads) {
  const ScratchDirectory scratch;
  const std::string model = robot_file("fc1d.yaml");
  const std::string machine = scratch.file("machine.yaml");
  std::ofstream(machine) << read_file(model) << "\neffects:\n  fc1d:\n    valve_deadband: {half_width_A: 0.0005}\n";
  const std::string trace = record(scratch, machine, "8");
  const std::string before = read_file(model);
  std::string output;
  ASSERT_EQ(run_farrier({"diagnose", trace, "--model", model, "--joint", "fc1d", "--out", scratch.file("out"), "--json",
                         scratch.file("found.json")},
                        &output),
            0)
      << output;
  const auto json = read_json(scratch.file("found.json"));
  ASSERT_FALSE(json["effects"].empty()) << output;
  EXPECT_EQ(json["effects"][0]["name"], "valve_deadband") << output;
  EXPECT_EQ(json["effects"][0]["parameter"], "half_width_A");
  EXPECT_NEAR(json["effects"][0]["value"].get<double>(), 0.0005, 0.0001) << output;
  EXPECT_LT(json["held_out"]["nrmse_after"].get<double>(), json["held_out"]["nrmse_before"].get<double>());
  const std::string extended = scratch.file("out/fc1d_fc1d_extended.yaml");
  EXPECT_EQ(json["extended_model"], extended);
  std::string printed;
  EXPECT_EQ(run_farrier({"trot", "--world", "bench", "--robot", extended, "--print-config"}, &printed), 0) << printed;
  EXPECT_NE(printed.find("valve_deadband"), std::string::npos);
  EXPECT_EQ(read_file(model), before) << "the user's file";
  EXPECT_FALSE(fs::exists(scratch.file("out/figures.json"))) << "--json said where";
}

TEST(Diagnose, TellsWhatARecordingCanShowBeforeAnyVerdict) {
  const ScratchDirectory scratch;
  const std::string recording = record(scratch, robot_file("fc1d.yaml"), "3");
  const std::string json_path = scratch.file("told.json");
  std::string output;
  ASSERT_EQ(run_farrier(
                {"diagnose", recording, "--model", robot_file("fc1d.yaml"), "--what-can-be-told", "--json", json_path},
                &output),
            0)
      << output;
  EXPECT_NE(output.find("could be taken for"), std::string::npos) << output;
  const auto json = read_json(json_path);
  const auto friction =
      std::ranges::find_if(json["effects"], [](const auto& one) { return one["name"] == "load_friction"; });
  ASSERT_NE(friction, json["effects"].end()) << json;
  EXPECT_TRUE((*friction)["shows"]);
  EXPECT_GT((*friction)["shows_from"]["value"], 0.0);
  EXPECT_FALSE(json.contains("verdict"));
}

TEST(Diagnose, TellsWhichEffectsOfASetARecordingSeparates) {
  const ScratchDirectory scratch;
  const std::string recording = record(scratch, robot_file("fc1d.yaml"), "3");
  const std::string json_path = scratch.file("told.json");
  const auto ask = [&](const std::string& set, std::string& output) {
    return run_farrier({"diagnose", recording, "--model", robot_file("fc1d.yaml"), "--what-can-be-told", "--set", set,
                        "--json", json_path},
                       &output);
  };
  std::string output;
  ASSERT_EQ(ask("load_damping,load_friction", output), 0) << output;
  EXPECT_NE(output.find("deviations"), std::string::npos) << output;
  const auto json = read_json(json_path);
  ASSERT_EQ(json["set"].size(), 2u) << json;
  EXPECT_EQ(json["set"][0]["name"], "load_damping");
  EXPECT_EQ(json["separable"], json["set"][0]["separable"] && json["set"][1]["separable"]);
  EXPECT_FALSE(json.contains("effects"));
  EXPECT_EQ(ask("load_damping,load_mess", output), 2);
  EXPECT_NE(output.find("no effect is called 'load_mess'"), std::string::npos) << output;
  EXPECT_NE(output.find("load_mass"), std::string::npos) << output;
  EXPECT_EQ(ask("cogging", output), 2);
  EXPECT_NE(output.find("cannot have 'cogging'"), std::string::npos) << output;
  EXPECT_EQ(ask("load_mass,load_mass", output), 2);
  EXPECT_NE(output.find("stands twice"), std::string::npos) << output;
}

TEST(Diagnose, RefusesBadDataWithItsRowsAndStillWritesThem) {
  const ScratchDirectory scratch;
  write_recording(scratch.file("run.csv"), [](int i, const std::string& line) {
    return i == 700 ? line.substr(0, line.rfind(',')) + ",nan" : line;
  });
  std::string output;
  const auto json = refusal_of(scratch, scratch.file("run.csv"), output);
  EXPECT_NE(output.find("run.csv:702:"), std::string::npos) << output;
  EXPECT_EQ(json["verdict"], "bad_data");
  ASSERT_FALSE(json["findings"].empty());
  EXPECT_EQ(json["findings"][0]["what"], "nan");
  EXPECT_EQ(json["findings"][0]["row"], 702);
}

TEST(Diagnose, NamesReversedForcesBeforeAnyEffect) {
  const ScratchDirectory scratch;
  const std::string trace = record(scratch, robot_file("fc1d.yaml"), "2");
  std::ifstream in(trace);
  std::ofstream out(scratch.file("reversed.csv"));
  std::size_t force = 0;
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) {
      cells.push_back(cell);
    }
    if (const auto found = std::ranges::find(cells, "force_N_or_Nm"); found != cells.end()) {
      force = static_cast<std::size_t>(found - cells.begin());
    } else {
      std::string& cell = cells.at(force);
      cell = cell.starts_with('-') ? cell.substr(1) : "-" + cell;
    }
    for (const std::string& cell : cells) {
      out << (&cell == cells.data() ? "" : ",") << cell;
    }
    out << "\n";
  }
  out.close();
  std::string output;
  const auto json = refusal_of(scratch, scratch.file("reversed.csv"), output);
  EXPECT_NE(output.find("is reversed: the load cell's wires are exchanged"), std::string::npos) << output;
  EXPECT_EQ(json["verdict"], "wiring");
  EXPECT_EQ(json["wiring"][0]["what"], "reversed");
  EXPECT_EQ(json["wiring"][0]["columns"], "force_N");
  EXPECT_EQ(json["findings"].size(), json["wiring"].size());
}

TEST(Diagnose, RefusesAFileThatIsNotThere) {
  const ScratchDirectory scratch;
  std::string output;
  const auto json = refusal_of(scratch, scratch.file("no.csv"), output);
  EXPECT_NE(output.find("no.csv"), std::string::npos) << output;
  EXPECT_EQ(json["findings"][0]["what"], "unreadable");
}

TEST(Diagnose, RefusesJointsThatTheRobotDoesNotHaveAndNamesThoseItHas) {
  std::string output;
  EXPECT_EQ(run_farrier({"diagnose", "run.csv", "--model", robot_file("hyq.yaml"), "--joint", "elbow"}, &output), 2);
  EXPECT_NE(output.find("no joint 'elbow'"), std::string::npos) << output;
  EXPECT_NE(output.find("lf_kfe"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"diagnose", "run.csv", "--model", robot_file("hyq.yaml")}, &output), 2);
  EXPECT_NE(output.find("give --joint"), std::string::npos) << output;
}

TEST(Diagnose, RefusesToGoWithoutRecordingOrModel) {
  std::string output;
  EXPECT_EQ(run_farrier({"diagnose"}, &output), 2);
  EXPECT_NE(output.find("name a recording"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"diagnose", "run.csv"}, &output), 2);
  EXPECT_NE(output.find("--model"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"diagnose", "run.csv", "--model", "nowhere.yaml"}, &output), 2);
  EXPECT_NE(output.find("nowhere.yaml"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"diagnose", "run.csv", "--model", robot_file("fc1d.yaml"), "--seed", "2"}, &output), 2);
  EXPECT_NE(output.find("--seed requires --benchmark or --wiring"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"diagnose", "run.csv", "--colour"}, &output), 2);
  EXPECT_NE(output.find("farrier diagnose --help"), std::string::npos) << output;
}

TEST(Diagnose, NeverWritesOverWhatItReads) {
  const ScratchDirectory scratch;
  const std::string model = scratch.file("fc1d_fc1d_extended.yaml");
  fs::copy_file(robot_file("fc1d.yaml"), model);
  const std::string before = read_file(model);
  write_recording(scratch.file("run.csv"), [](int, const std::string& line) { return line; });
  const std::string recorded = read_file(scratch.file("run.csv"));
  std::string output;
  EXPECT_EQ(run_farrier({"diagnose", scratch.file("run.csv"), "--model", model, "--out", scratch.file("")}, &output),
            2);
  EXPECT_NE(output.find("is what is read"), std::string::npos) << output;
  EXPECT_EQ(
      run_farrier({"diagnose", scratch.file("run.csv"), "--model", model, "--json", scratch.file("run.csv")}, &output),
      2);
  EXPECT_EQ(read_file(model), before);
  EXPECT_EQ(read_file(scratch.file("run.csv")), recorded);
}

TEST(Diagnose, LeavesNoFilesWhenItIsInterrupted) {
  const ScratchDirectory scratch;
  const std::string trace = record(scratch, robot_file("fc1d.yaml"), "30");
  FarrierCommand command({"diagnose", trace, "--model", robot_file("fc1d.yaml"), "--out", scratch.file("out")});
  ASSERT_TRUE(command.says("diagnose: percent")) << command.output();
  command.signal(SIGINT);
  EXPECT_EQ(command.wait(std::chrono::seconds(20)), 130) << command.output();
  EXPECT_NE(command.output().find("nothing was written"), std::string::npos) << command.output();
  EXPECT_TRUE(fs::is_empty(scratch.file("out")));
}

}  // namespace diagnose_test
}  // namespace farrier::test
