// Memory and time of commands on a file of 10 GB that is sparse, and on a clock that was set: printed, and bounded.

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>

#include "tests/system/farrier_command.hpp"
#include "recording/recording_file.hpp"
#include "report/figures/recording_facts.hpp"
#include "tests/cases/any_mcap.hpp"

namespace farrier::test {
namespace memory_test {

using namespace std::chrono_literals;
using Arguments = std::vector<std::string>;

constexpr const char* kDomain = "95";  // of no run
constexpr Tick kTicks = 2000;
// A command on a small ordinary file has up to 40 MB, most of which are libraries.
constexpr double kMost_MB = 120.0;

/// Largest memory that a running process has had.
double peak_MB(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) {
      return std::stod(line.substr(line.find(':') + 1)) / 1024.0;
    }
  }
  return 0.0;
}

class Memory : public testing::Test {
 protected:
  /// Runs a command until it ends, or says `until`; prints and bounds its memory.
  void measure(const Arguments& arguments, const std::string& until = "") const {
    const auto begin = std::chrono::steady_clock::now();
    FarrierCommand command(arguments);
    double most_MB = 0.0;
    bool ended = false;
    while (!ended && std::chrono::steady_clock::now() - begin < 60s) {
      const double now_MB = peak_MB(command.pid());
      most_MB = std::max(most_MB, now_MB);
      ended = now_MB == 0.0 || (!until.empty() && command.output().find(until) != std::string::npos);
    }
    EXPECT_TRUE(ended) << command.output();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    if (!until.empty()) {
      command.signal(SIGTERM);
    }
    const int status = command.wait(10s);
    EXPECT_EQ(status, until.empty() ? 0 : 128 + SIGTERM) << command.output();
    std::printf("%-30s %6.1f MB at most, %5.2f s\n",
                (arguments[0] + (arguments[1].starts_with("--") ? " " + arguments[1] : "")).c_str(), most_MB,
                took.count());
    EXPECT_LT(most_MB, kMost_MB) << arguments[0];
    EXPECT_GT(most_MB, 0.0);
  }
  void measure_all() const {
    measure({"info", path_});
    measure({"monitor", "--open", path_, "--web", "0"}, "http://");
    measure({"replay", path_, "--speed", "10", "--domain", kDomain});
  }

  const ScratchDirectory scratch_;
  const std::string path_ = scratch_.file("run.mcap");
};

TEST_F(Memory, FollowsTheSamplesOfASparseFileOfTenGigabytes) {
  constexpr std::uint64_t kPart = 2'500'000'000;
  AnyMcap file = ordinary_file(leg(), bench_samples(leg(), kTicks, kBegin_ns), Packing::kZstd);
  file.put_attachment(kPart);
  file.put_large_metadata(kPart);
  file.put(mcap::Channel{.id = 900, .topic = "/camera", .message_encoding = "cdr"});
  file.close_loose();
  file.put_large_message(900, kPart);
  file.put_attachment(kPart);
  file.put_data_end();
  file.put_footer();
  file.save(path_);
  EXPECT_GE(std::filesystem::file_size(path_), 10'000'000'000u);
  measure_all();
}

TEST_F(Memory, FollowsTheSamplesWhereTheClockIsSetAgainAndAgain) {
  std::vector<PlacedSample> samples = bench_samples(leg(), kTicks, 1'000'000'000);
  for (PlacedSample& sample : samples) {
    sample.log_time_ns += sample.sequence % 200 < 100 ? 0 : kBegin_ns;  // 1970, 2023, 1970, ...
  }
  AnyMcap file = ordinary_file(leg(), samples, Packing::kZstd);
  file.put_data_end();
  file.put_footer();
  file.save(path_);
  measure_all();
}

}  // namespace memory_test
}  // namespace farrier::test
