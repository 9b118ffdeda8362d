// farrier trot of a robot with a body, as a user runs it: the whole robot walks on a ground.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/system/farrier_command.hpp"

namespace farrier::test {
namespace walk_test {

/// The robot walks from the eighth second on.
const char* const kWalks = tested_duration("9.5");

struct Traces {
  std::string joints, body, supply;
  bool of_processes;  ///< each has a log
};

/// The traces of a walk with these options. It is too short to be judged.
Traces traces_of(const std::vector<std::string>& options) {
  const ScratchDirectory scratch;
  std::vector<std::string> arguments{"trot", "--duration", kWalks, "--out", scratch.file("out")};
  arguments.insert(arguments.end(), options.begin(), options.end());
  std::string output;
  run_farrier(arguments, &output);
  const Traces traces{read_file(scratch.file("out/trace.csv")), read_file(scratch.file("out/trace_body.csv")),
                      read_file(scratch.file("out/trace_supply.csv")),
                      std::filesystem::exists(scratch.file("out/log/supervisor.log"))};
  EXPECT_GT(traces.body.size(), 1000u) << output;
  EXPECT_GT(traces.supply.size(), 1000u) << output;
  return traces;
}

// Feet meet blocks before their plan, all valves lose half their gain, and the gains adapt.
TEST(Walk, LeavesTheSameTracesOverEveryTransportAndGrouping) {
  const ScratchDirectory scratch;
  std::ofstream(scratch.file("hard.yaml"))
      << "actuators: {coils: {start_s: 8.6, valve_gain_factor: 0.5}}\n"
         "blocks: {field: {x_m: 0.45, y_m: -1.5, length_m: 3, width_m: 3, height_m: 0.08}}\n";
  const auto hard = [&](std::vector<std::string> way) {
    way.insert(way.end(), {"--design", "adaptive", "--scene", scratch.file("hard.yaml")});
    return traces_of(way);
  };
  const Traces reference = hard({"--dds", "inproc", "--nodes", "per-leg"});
  EXPECT_FALSE(reference.of_processes);
  // Twelve joint_nodes over DDS take a minute of two processors and are for the trot on the bench.
  const std::vector<std::string> ways[] = {{},  // cyclone, per-leg: as a plain ./farrier trot
                                           {"--dds", "fast", "--nodes", "one"},
                                           {"--dds", "mixed", "--nodes", "per-leg"},
                                           {"--dds", "inproc", "--nodes", "per-joint"}};
  for (const std::vector<std::string>& way : ways) {
    const Traces other = hard(way);
    SCOPED_TRACE(testing::PrintToString(way));
    EXPECT_EQ(other.of_processes, way != ways[3]);
    EXPECT_TRUE(other.joints == reference.joints);
    EXPECT_TRUE(other.body == reference.body);
    EXPECT_TRUE(other.supply == reference.supply);
  }
}

TEST(Walk, IsJudgedByItsBody) {
  const ScratchDirectory scratch;
  std::string output;
  ASSERT_EQ(run_farrier({"trot", "--dds", "inproc", "--velocity", "0.4,0,0", "--out", scratch.file("out")}, &output), 0)
      << output;
  const auto json = read_json(scratch.file("out/figures.json"));
  EXPECT_EQ(figure(json, "trot.body.falls"), 0.0);
  EXPECT_NE(output.find("hyq walked 4."), std::string::npos) << output;
  EXPECT_GT(figure(json, "trot.body.way_m"), 4.0);
  for (const char* picture : {"walk", "moving", "supply", "energy", "leg_lf", "leg_rh"}) {
    EXPECT_TRUE(std::filesystem::exists(scratch.file("out/pictures/" + std::string(picture) + ".svg"))) << picture;
  }
}

TEST(Walk, ThatEndsInAFallSaysWhenAndWhy) {
  const ScratchDirectory scratch;
  std::ofstream(scratch.file("kick.yaml")) << "pushes: {kick: {start_s: 9, impulse_y_Ns: 600}}\n";
  std::string output;
  EXPECT_EQ(run_farrier({"trot", "--world", "body", "--dds", "inproc", "--scene", scratch.file("kick.yaml"),
                         "--duration", "11", "--out", scratch.file("out")},
                        &output),
            1);
  EXPECT_NE(output.find("the robot fell after 9."), std::string::npos) << output;
  EXPECT_NE(output.find("the trunk tilts by"), std::string::npos) << output;
  EXPECT_TRUE(std::filesystem::exists(scratch.file("out/pictures/fall.svg")));
}

TEST(Walk, RefusesWhatItCannotDo) {
  const ScratchDirectory scratch;
  std::ofstream(scratch.file("scene.yaml")) << "pushes: {kick: {body: tail, start_s: 9, impulse_y_Ns: 6}}\n";
  std::string output;
  const std::vector<std::string> walk{"trot", "--world", "body", "--out", scratch.file("out")};
  const auto refuses = [&](std::vector<std::string> options, const std::string& words) {
    options.insert(options.begin(), walk.begin(), walk.end());
    EXPECT_EQ(run_farrier(options, &output), 2) << output;
    EXPECT_NE(output.find(words), std::string::npos) << output;
  };
  refuses({"--scene", scratch.file("scene.yaml")}, "scene.yaml:1");
  refuses({"--design", "adaptive", "--controller", "pid"}, "its gains do not adapt");
  refuses({"--design", "adaptive", "--estimator", "rls"}, "it finds no valve");
  refuses({"--design", "adaptive", "--controller", "lqr"}, "its estimates are not valid there");
  refuses({"--gait", "stand"}, "the gait 'stand' is for the bench");
  refuses({"--velocity", "0.4,0"}, "--velocity");
}

TEST(Walk, OfARobotWithoutATrunkIsARunOnTheBench) {
  const ScratchDirectory scratch;
  std::string output;
  run_farrier({"trot", "--world", "body", "--dds", "inproc", "--duration", "2", "--robot",
               std::string(FARRIER_ROBOTS) + "/fc1d.yaml", "--out", scratch.file("out")},
              &output);
  EXPECT_NE(output.find("it runs on the bench"), std::string::npos) << output;
  EXPECT_TRUE(std::filesystem::exists(scratch.file("out/trace.csv"))) << output;
}

}  // namespace walk_test
}  // namespace farrier::test
