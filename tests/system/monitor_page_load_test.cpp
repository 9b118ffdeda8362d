// Processor time of farrier monitor --web while a robot runs in real time and a page watches.

#include <gtest/gtest.h>

#include "farrier_command.hpp"
#include "page_stream.hpp"
#include "tests/support/http_get.hpp"
#include "cli/processes/process_stat.hpp"

namespace farrier::test {
namespace monitor_page_load_test {

using namespace std::chrono_literals;

constexpr double kLargestShare = 0.05;  // of a core, at 1 kHz and twelve joints
constexpr auto kMeasured = 8s;

TEST(MonitorPageLoad, IsAtMostAFewHundredthsOfACore) {
  const ScratchDirectory scratch;
  FarrierCommand trot(
      {"trot", "--world", "bench", "--clock", "realtime", "--duration", "60", "--out", scratch.file("out")});
  ASSERT_TRUE(trot.says("trot: tick 0 of")) << trot.output();
  const std::uint16_t port = free_port();
  FarrierCommand monitor({"monitor", "--web", std::to_string(port), "--domain", std::to_string(trot.domain())});
  ASSERT_TRUE(monitor.says("page at", 30s)) << monitor.output();
  const auto until = std::chrono::steady_clock::now() + 3s;  // for readers and writers to find each other
  frames_until(port, [&](const auto&) { return std::chrono::steady_clock::now() > until; });
  const double before_s = cli::process_stat(monitor.pid()).value().processor_s;
  const auto begin = std::chrono::steady_clock::now();
  const auto frames =
      frames_until(port, [&](const auto&) { return std::chrono::steady_clock::now() > begin + kMeasured; });
  const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const double share = (cli::process_stat(monitor.pid()).value().processor_s - before_s) / took_s;
  RecordProperty("share_percent", std::to_string(100.0 * share));
  std::printf("farrier monitor --web: %.2f %% of a core, %.1f frames/s\n", 100.0 * share,
              static_cast<double>(frames.size()) / took_s);
  EXPECT_LE(share, kLargestShare);
  monitor.signal(SIGINT);
  monitor.wait(5s);
  trot.signal(SIGINT);
  trot.wait(20s);
}

}  // namespace monitor_page_load_test
}  // namespace farrier::test
