// farrier monitor --web beside a running trot, and of a recording.

#include <gtest/gtest.h>

#include <algorithm>

#include "beside_a_trot.hpp"
#include "page_stream.hpp"
#include "tests/support/http_get.hpp"

namespace farrier::test {
namespace monitor_page_test {

using namespace std::chrono_literals;
using nlohmann::json;

class MonitorPage : public BesideATrotByVendor {
 protected:
  static std::vector<std::string> monitor(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "monitor");
    const std::vector<std::string> where = beside();
    arguments.insert(arguments.end(), where.begin(), where.end());
    return arguments;
  }
};

bool every_joint_tracks(const json& frame) {
  return std::ranges::all_of(frame.at("joints"), [](const json& joint) { return joint.at("state") == 2; });
}

TEST_P(MonitorPage, ShowsEveryJointOfARunningRobot) {
  const std::uint16_t port = free_port();
  FarrierCommand command(monitor({"--web", std::to_string(port)}));
  ASSERT_TRUE(command.says("page at http://127.0.0.1:" + std::to_string(port) + "/", 30s)) << command.output();
  EXPECT_NE(http_get(port, "/").find("<title>Farrier monitor</title>"), std::string::npos);
  EXPECT_EQ(json::parse(http_get(port, "/api/robot")).at("joints").size(), 12u);
  const auto until = std::chrono::steady_clock::now() + 30s;
  const auto frames = frames_until(port, [&](const json& frame) {
    return (every_joint_tracks(frame) && frame.at("mode") == "armed") || std::chrono::steady_clock::now() > until;
  });
  ASSERT_FALSE(frames.empty());
  EXPECT_TRUE(every_joint_tracks(frames.back())) << frames.back().dump();
  EXPECT_EQ(frames.back().at("mode"), "armed");
  command.signal(SIGINT);
  EXPECT_EQ(command.wait(10s), 130);
}

TEST(MonitorPageOfARecording, ShowsWhatWasRecorded) {
  const ScratchDirectory scratch;
  const std::string path = scratch.file("run.mcap");
  std::string output;
  ASSERT_EQ(run_farrier({"trot", "--world", "bench", "--dds", "inproc", "--duration", "4", "--record", path, "--out",
                         scratch.file("out")},
                        &output),
            0)
      << output;
  const std::uint16_t port = free_port();
  FarrierCommand command({"monitor", "--open", path, "--port", std::to_string(port)});
  ASSERT_TRUE(command.says(path + " at http://127.0.0.1:" + std::to_string(port) + "/", 30s)) << command.output();
  const json recording = json::parse(http_get(port, "/api/recording"));
  EXPECT_GT(recording.at("opens_at_s").get<double>(), 0.5 * recording.at("duration_s").get<double>());
  const std::size_t count = recording.at("frames");
  const json frames = json::parse(http_get(port, "/api/frames?from=" + std::to_string(count - 1)));
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_TRUE(every_joint_tracks(frames.back())) << frames.back().dump();
  command.signal(SIGTERM);
  EXPECT_EQ(command.wait(2s), 143);
}

INSTANTIATE_TEST_SUITE_P(Over, MonitorPage, testing::Values("cyclone", "fast"),
                         [](const auto& dds) { return std::string(dds.param); });

TEST(MonitorPageCommand, RefusesWhatItCannotDo) {
  std::string output;
  EXPECT_EQ(run_farrier({"monitor", "--web", "localhost"}, &output), 2);
  EXPECT_NE(output.find("--web: "), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"monitor", "--open", "/nowhere.mcap"}, &output), 2);
  EXPECT_EQ(run_farrier({"monitor", "--web", "--once"}, &output), 2);
  EXPECT_EQ(run_farrier({"monitor", "--open", FARRIER_ROBOTS "/hyq.yaml"}, &output), 2);
}

}  // namespace monitor_page_test
}  // namespace farrier::test
