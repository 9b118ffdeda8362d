// A run in real time leaves every process with the memory, threads and descriptors that it had after its first tenth.

#include <gtest/gtest.h>

#include "farrier_command.hpp"

namespace farrier::test {
namespace soak_test {

constexpr std::size_t kStarted = 8;  // all but the launcher
constexpr auto kPatience = std::chrono::minutes(50);

class Soak : public testing::TestWithParam<const char*> {};

TEST_P(Soak, LetsNoProcessGrow) {
  const ScratchDirectory scratch;
  FarrierCommand trot({"trot", "--world", "bench", "--clock", "realtime", "--no-comparison", "--soak", "--dds",
                       GetParam(), "--nodes", "per-leg", "--duration", tested_duration("5"), "--out",
                       scratch.file("out")});
  ASSERT_NE(trot.wait(kPatience), -1);
  const nlohmann::json run = read_json(scratch.file("out/figures.json"));
  ASSERT_FALSE(run.is_discarded()) << trot.output();
  // The tracking of the joints depends on the computer and is not checked.
  for (const auto& entry : run["figures"]) {
    if (entry["name"].get<std::string>().ends_with("_growth") || entry["name"] == "trot.memory_growth_KiB") {
      EXPECT_TRUE(entry["holds"].get<bool>()) << entry << run.value("failures", nlohmann::json());
    }
  }
  std::size_t watched = 0;
  for (const auto& process : run["run"]["processes"]) {
    watched += process.contains("growth") ? 1 : 0;
  }
  EXPECT_EQ(watched, kStarted);
  EXPECT_EQ(figure(run, "trot.descriptors_growth"), 0.0);
}

TEST(SoakOption, IsForProcessesOfTheirOwn) {
  const ScratchDirectory scratch;
  std::string output;
  EXPECT_EQ(run_farrier({"trot", "--soak", "--dds", "inproc", "--out", scratch.file("out")}, &output), 2);
  EXPECT_NE(output.find("--soak watches the processes of one run over DDS"), std::string::npos) << output;
}

INSTANTIATE_TEST_SUITE_P(Over, Soak, testing::ValuesIn(tested_vendors("mixed")),
                         [](const auto& dds) { return std::string(dds.param); });

}  // namespace soak_test
}  // namespace farrier::test
