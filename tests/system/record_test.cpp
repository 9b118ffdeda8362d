// farrier record and farrier info beside a running trot.

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "beside_a_trot.hpp"
#include "bus/topics.hpp"

namespace farrier::test {
namespace record_test {

using namespace std::chrono_literals;
using nlohmann::json;

constexpr int kDomainOfReplays = 96;  // of no run: theirs are low

class Record : public BesideATrotByVendor {
 protected:
  /// These tests have the computer to themselves, and measure rates.
  static void SetUpTestSuite() {
    BesideATrot::SetUpTestSuite();
    trot_->renice(0);
  }

  std::vector<std::string> record(const std::string& path, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = beside();
    arguments.insert(arguments.begin(), {"record", path});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  /// The file of two seconds of the trot, which is recorded for the first test that asks.
  std::string two_seconds() const {
    const std::string path = scratch_->file(std::string(GetParam()) + ".mcap");
    if (!std::filesystem::exists(path)) {
      std::string output;
      EXPECT_EQ(run_farrier(record(path, {"--duration", "2", "--fact", "seed=1"}), &output), 0) << output;
    }
    return path;
  }

  /// Ends a recording some seconds after it has begun, by this signal; the command's exit status.
  static int record_until(int signal, const std::vector<std::string>& arguments, std::chrono::seconds after) {
    FarrierCommand command(arguments);
    EXPECT_TRUE(command.says("Ctrl-C ends it", 20s)) << command.output();
    std::this_thread::sleep_for(after);
    command.signal(signal);
    return command.wait(10s);
  }
};

TEST_P(Record, TakesEveryTopicThatMovesAndCountsWhatItLost) {
  std::string output;
  ASSERT_EQ(run_farrier({"info", two_seconds(), "--json"}, &output), 0) << output;
  const json info = json::parse(output);
  EXPECT_TRUE(info.at("whole"));
  EXPECT_EQ(info.at("run").at("robot"), "hyq");
  EXPECT_EQ(info.at("run").at("seed"), "1");
  EXPECT_NE(info.at("run").at("configuration").get<std::string>().find("joints"), std::string::npos);
  EXPECT_EQ(info.at("topics").size(), bus::kTopicCount);
  for (const char* topic : {"joint/sensors", "joint/command", "joint/valve_command", "joint/measurement",
                            "joint/controller_gains", "system/hello", "system/mode", "clock/tick"}) {
    EXPECT_GT(info.at("topics").at(topic).at("samples"), 0) << topic;
    EXPECT_TRUE(info.at("topics").at(topic).contains("lost")) << topic;
  }
  // Topics of which a sample for every joint and tick is published together must have the same rate, with lost samples,
  // and about the same duration. Their numbers may differ: topics are found one after another.
  const auto duration_s = [&](const char* topic) { return info.at("topics").at(topic).at("duration_s").get<double>(); };
  const auto rate_hz = [&](const char* topic) {
    const json& of = info.at("topics").at(topic);
    return (of.at("samples").get<double>() + of.at("lost").get<double>()) / duration_s(topic);
  };
  EXPECT_NEAR(rate_hz("joint/sensors") / rate_hz("joint/measurement"), 1.0, 0.05);
  EXPECT_NEAR(rate_hz("joint/sensors") / (12.0 * rate_hz("clock/tick")), 1.0, 0.05);
  EXPECT_NEAR(duration_s("joint/sensors"), duration_s("joint/measurement"), 0.5);
  EXPECT_NEAR(duration_s("joint/sensors"), duration_s("clock/tick"), 0.5);
}

TEST_P(Record, TakesOnlyTheTopicsAskedFor) {
  const std::string path = scratch_->file("some.mcap");
  std::string output;
  ASSERT_EQ(run_farrier(record(path, {"--duration", "1", "--topics", "clock/tick"}), &output), 0) << output;
  ASSERT_EQ(run_farrier({"info", path, "--json"}, &output), 0) << output;
  const json topics = json::parse(output).at("topics");
  EXPECT_GT(topics.at("clock/tick").at("samples"), 0);
  EXPECT_EQ(topics.at("joint/sensors").at("samples"), 0);
}

TEST_P(Record, KilledLeavesAFileThatIsReadableUpToItsLastChunk) {
  const std::string path = scratch_->file("killed.mcap");
  ASSERT_EQ(record_until(SIGKILL, record(path), 3s), 128 + SIGKILL);
  EXPECT_FALSE(std::filesystem::exists(path)) << "a recording has its name once it is whole";
  std::string output;
  EXPECT_EQ(run_farrier({"info", path + ".part"}, &output), 1) << output;
  EXPECT_NE(output.find("cut off"), std::string::npos) << output;
  EXPECT_NE(output.find("joint/measurement"), std::string::npos) << output;
}

TEST_P(Record, EndsItsFileWhenAskedToStop) {
  const std::string path = scratch_->file("stopped.mcap");
  ASSERT_EQ(record_until(SIGINT, record(path), 1s), 0);
  std::string output;
  EXPECT_EQ(run_farrier({"info", path}, &output), 0) << output;
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST_P(Record, ReplayedIsPublishedAgain) {
  const std::string path = two_seconds();
  const std::string again = scratch_->file("replayed.mcap");
  const std::string domain = std::to_string(kDomainOfReplays);
  std::string output;
  FarrierCommand listener({"record", again, "--domain", domain, "--dds", GetParam()});
  ASSERT_TRUE(listener.says("Ctrl-C ends it", 20s)) << listener.output();
  ASSERT_EQ(run_farrier({"replay", path, "--domain", domain, "--dds", GetParam()}, &output), 0) << output;
  listener.signal(SIGINT);
  ASSERT_EQ(listener.wait(10s), 0) << listener.output();
  ASSERT_EQ(run_farrier({"info", path, "--json"}, &output), 0) << output;
  const json before = json::parse(output);
  ASSERT_EQ(run_farrier({"info", again, "--json"}, &output), 0) << output;
  const json after = json::parse(output);
  for (const char* topic : {"joint/measurement", "joint/sensors", "clock/tick"}) {
    const double recorded = before.at("topics").at(topic).at("samples");
    const double replayed = after.at("topics").at(topic).at("samples");
    EXPECT_GT(recorded, 0.0) << topic;
    EXPECT_NEAR(replayed / recorded, 1.0, 0.05) << topic;  // best effort
  }
  EXPECT_NEAR(after.at("duration_s").get<double>(), before.at("duration_s").get<double>(), 0.5);
}

TEST_P(Record, IsNotReplayedWhereARobotRuns) {
  std::vector<std::string> replay = beside();
  replay.insert(replay.begin(), {"replay", two_seconds()});
  std::string output;
  EXPECT_EQ(run_farrier(replay, &output), 2);
  EXPECT_NE(output.find("would speak in its name"), std::string::npos) << output;
}

TEST(RealTimeRecording, HasTheMeasurementsOfARun) {
  const ScratchDirectory scratch;
  const std::string path = scratch.file("run.mcap");
  std::string output;
  // The timing of a computer of two processors while it records is not checked here.
  const int status = run_farrier({"trot", "--world", "bench", "--clock", "realtime", "--no-comparison", "--duration",
                                  "2", "--record", path, "--out", scratch.file("out")},
                                 &output);
  EXPECT_TRUE(status == 0 || status == 1) << output;
  std::string text;
  ASSERT_EQ(run_farrier({"info", path, "--json"}, &text), 0) << text;
  const json info = json::parse(text);
  EXPECT_TRUE(info.at("whole"));
  EXPECT_EQ(info.at("run").at("clock"), "realtime");
  EXPECT_GT(info.at("topics").at("joint/measurement").at("samples"), 0) << output;
  EXPECT_GT(info.at("topics").at("lf/joint/summary").at("samples"), 0) << output;
}

INSTANTIATE_TEST_SUITE_P(Over, Record, testing::ValuesIn(tested_vendors("cyclone")),
                         [](const auto& dds) { return std::string(dds.param); });

}  // namespace record_test
}  // namespace farrier::test
