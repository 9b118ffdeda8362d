// The command on a computer that is not as its authors have it: environment, directories, disks.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/processes.hpp"
#include "farrier_command.hpp"

namespace farrier::test {
namespace surroundings_test {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr const char* kShort = "0.3";  // seconds; too short to be judged, long enough to have a trace

/// A trace over DDS takes more than this, a log less.
constexpr rlim_t kDiskBytes = 100'000;

Surroundings with_environment(const std::string& name, const std::string& value) {
  return {FARRIER_COMMAND, [=] { ::setenv(name.c_str(), value.c_str(), 1); }};
}

TEST(Environment, ChoosesTheVendorWhereTheCommandLineDoesNot) {
  const ScratchDirectory scratch;
  run_farrier({"trot", "--world", "bench", "--duration", kShort, "--out", scratch.file("out")}, nullptr,
              with_environment("FARRIER_DDS", "fast"));
  const nlohmann::json figures = read_json(scratch.file("out/figures.json"));
  ASSERT_FALSE(figures.is_discarded());
  for (const auto& process : figures["run"]["processes"]) {
    EXPECT_EQ(process["vendor"], "fast") << process["name"];
  }
}

TEST(Environment, YieldsToTheCommandLine) {
  const ScratchDirectory scratch;
  run_farrier({"trot", "--world", "bench", "--dds", "inproc", "--duration", kShort, "--out", scratch.file("out")},
              nullptr, with_environment("FARRIER_DDS", "fast"));
  const nlohmann::json figures = read_json(scratch.file("out/figures.json"));
  ASSERT_FALSE(figures.is_discarded());
  EXPECT_EQ(figures["run"]["processes"][0]["vendor"], "inproc");
}

TEST(Environment, IsRefusedWhereItNamesNoVendor) {
  const ScratchDirectory scratch;
  std::string output;
  EXPECT_EQ(run_farrier({"trot", "--world", "bench", "--out", scratch.file("out")}, &output,
                        with_environment("FARRIER_DDS", "zenoh")),
            2);
  EXPECT_NE(output.find("'zenoh' is not one of"), std::string::npos) << output;
  EXPECT_FALSE(fs::exists(scratch.file("out")));
}

TEST(WorkingDirectory, MayBeAnyWithAnyName) {
  const ScratchDirectory scratch;
  const std::string directory = scratch.file("a 'quoted' dir, ünd more");
  fs::create_directory(directory);
  std::string output;
  run_farrier({"trot", "--world", "bench", "--duration", kShort, "--json", "here.json"}, &output,
              {FARRIER_COMMAND, [&] {
                 if (::chdir(directory.c_str()) != 0) {
                   ::_exit(127);
                 }
               }});
  EXPECT_TRUE(fs::exists(directory + "/here.json")) << output;
  EXPECT_TRUE(fs::exists(directory + "/out/trot/trace.csv")) << output;
  EXPECT_TRUE(fs::exists(directory + "/out/trot/index.html")) << output;
}

struct BadPlace {
  const char* name;
  const char* option;
  const char* path;
};

class UnwritableOutput : public testing::TestWithParam<BadPlace> {};

TEST_P(UnwritableOutput, IsRefusedByNameBeforeAnythingMoves) {
  const ScratchDirectory scratch;
  std::vector<std::string> arguments{"trot", "--world", "bench", GetParam().option, GetParam().path};
  if (std::string(GetParam().option) != "--out") {
    arguments.insert(arguments.end(), {"--out", scratch.file("out")});
  }
  std::string output;
  EXPECT_EQ(run_farrier(arguments, &output), 2);
  EXPECT_NE(output.find(GetParam().path), std::string::npos) << output;
  EXPECT_EQ(output.find("tick"), std::string::npos) << output;
}

INSTANTIATE_TEST_SUITE_P(Of, UnwritableOutput,
                         testing::Values(BadPlace{"TraceInAMissingDirectory", "--trace", "/nowhere/trace.csv"},
                                         BadPlace{"TraceThatIsADirectory", "--trace", "/tmp"},
                                         BadPlace{"FiguresInAMissingDirectory", "--json", "/nowhere/figures.json"},
                                         BadPlace{"OutWhereNoDirectoryCanBe", "--out", "/proc/farrier"},
                                         BadPlace{"OutBelowAFile", "--out", "/dev/null/out"}),
                         [](const auto& place) { return std::string(place.param.name); });

TEST(OutputDirectory, IsRefusedWhileAnotherRunWritesThere) {
  const ScratchDirectory scratch;
  FarrierCommand first({"trot", "--world", "bench", "--duration", "600", "--out", scratch.file("out")});
  ASSERT_TRUE(first.says("trot: tick 0 of"));
  std::string output;
  EXPECT_EQ(
      run_farrier({"trot", "--world", "bench", "--dds", "inproc", "--duration", kShort, "--out", scratch.file("out")},
                  &output),
      2);
  EXPECT_NE(output.find("another run writes there"), std::string::npos) << output;
  first.signal(SIGINT);
  EXPECT_EQ(first.wait(20s), 130);
  run_farrier({"trot", "--world", "bench", "--dds", "inproc", "--duration", kShort, "--out", scratch.file("out")});
  EXPECT_TRUE(fs::exists(scratch.file("out/figures.json")));
}

TEST(FiguresOfAnEarlierRun, DoNotStandForOneThatWasInterrupted) {
  const ScratchDirectory scratch;
  fs::create_directory(scratch.file("out"));
  std::ofstream(scratch.file("out/figures.json")) << R"({"verdict": "pass"})";
  FarrierCommand trot({"trot", "--world", "bench", "--duration", "600", "--out", scratch.file("out")});
  ASSERT_TRUE(trot.says("trot: tick 0 of"));
  trot.signal(SIGINT);
  EXPECT_EQ(trot.wait(20s), 130);
  EXPECT_FALSE(fs::exists(scratch.file("out/figures.json")));
}

class FullDisk : public testing::TestWithParam<const char*> {};

// A limit on the size of files, with its signal ignored, fails writes as a full disk does.
TEST_P(FullDisk, FailsTheRunWithItsCause) {
  const ScratchDirectory scratch;
  std::string output;
  EXPECT_EQ(
      run_farrier({"trot", "--world", "bench", "--dds", GetParam(), "--duration", kShort, "--out", scratch.file("out")},
                  &output,
                  {FARRIER_COMMAND,
                   [] {
                     ::signal(SIGXFSZ, SIG_IGN);
                     const rlimit limit{kDiskBytes, kDiskBytes};
                     ::setrlimit(RLIMIT_FSIZE, &limit);
                   }}),
      1);
  EXPECT_NE(output.find("disk full"), std::string::npos) << output;
}

INSTANTIATE_TEST_SUITE_P(Over, FullDisk, testing::Values("inproc", "cyclone"),
                         [](const auto& dds) { return std::string(dds.param); });

TEST(JointNode, RefusesEveryJointTheRobotDoesNotHave) {
  std::string output;
  EXPECT_EQ(run_farrier({"--number", std::to_string(info(Program::kJointNode).number), "--participants", "9", "--robot",
                         FARRIER_ROBOTS "/hyq.yaml", "--joints", "lf_haa,lf_elbow,tail"},
                        &output, {FARRIER_JOINT_NODE, nullptr}),
            2);
  EXPECT_NE(output.find("'lf_elbow'"), std::string::npos) << output;
  EXPECT_NE(output.find("'tail'"), std::string::npos) << output;
  EXPECT_EQ(output.find("'lf_haa'"), std::string::npos) << output;
}

TEST(SupervisorProcess, RefusesAnUnknownDesign) {
  std::string output;
  const std::string supervisor = std::string(FARRIER_PREFIX) + "/libexec/farrier/supervisor";
  EXPECT_EQ(
      run_farrier({"--number", "2", "--participants", "8", "--robot", FARRIER_ROBOTS "/hyq.yaml", "--design", "clever"},
                  &output, {supervisor, nullptr}),
      2);
  EXPECT_NE(output.find("--design: there is no design 'clever': give one of stance, swing, phases, adaptive"),
            std::string::npos)
      << output;
}

}  // namespace surroundings_test
}  // namespace farrier::test
