#include "bench/command/bench_onlookers.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/median.hpp"
#include "participant/participant.hpp"
#include "recording/recording_file.hpp"
#include "bench/command/page_viewer.hpp"

namespace farrier::cli {
namespace {

constexpr Tick kRealtimeTicks = 10'000;
constexpr int kStoppedMonitors = 10;
// Alternating runs, of which the median pair counts: a computer's speed changes within a minute, hence many and short
// ones.
constexpr int kPairs = 15;
constexpr Tick kOfTheTicks = 2;  // the part that each takes
constexpr double kRecordPercent = 10.0;
constexpr double kMonitorPercent = 5.0;
constexpr double kWatchedRatio = 0.9;
constexpr double kStoppedLatencyRatio = 1.25;  // p50: what two runs of one kind differ by on a computer that others use

struct Recorded {
  double samples = 0.0, lost = 0.0;
  double seconds = 0.0;
};

Result<Recorded> read_recording(const std::string& path) {
  auto file = FARRIER_TRY(recording::RunFileReader::open(path));
  Recorded recorded;
  std::uint64_t first_ns = 0, last_ns = 0;
  for (recording::Sample sample; file.next(sample);) {
    first_ns = first_ns == 0 ? sample.log_time_ns : first_ns;
    last_ns = sample.log_time_ns;
    recorded.samples += 1.0;
  }
  if (!file.ending().empty()) {
    return Error{path + ": " + file.ending()};
  }
  for (const auto& [topic, lost] : file.metadata(recording::kLosses)) {
    recorded.lost += std::strtod(lost.c_str(), nullptr);
  }
  recorded.seconds = static_cast<double>(last_ns - first_ns) * 1e-9;
  return recorded;
}

Onlooker monitor_with_page(const std::string& name = "monitor") {
  return {.name = name, .arguments = {"monitor", "--web", "0"}, .listens = "page at"};
}

/// The runs of one vendor.
class VendorBench {
 public:
  VendorBench(const robot::Robot& robot, DdsRun plain, std::string out, report::Figures& figures)
      : robot_(robot),
        plain_(std::move(plain)),
        vendor_(to_string(plain_.dds == DdsChoice::kFast ? Vendor::kFast : Vendor::kCyclone)),
        recording_(out + "/" + vendor_ + ".mcap"),
        figures_(figures) {}

  Result<Done> lockstep() {
    std::vector<double> alone, watched, ratios;  // ticks per second; by pair
    for (int pair = 1; pair <= kPairs; ++pair) {
      // The order alternates, too: a speed that rises or falls for a while favours neither.
      for (const bool onlooked : {pair % 2 == 0, pair % 2 == 1}) {
        const auto ticks_per_s = FARRIER_TRY(lockstep_ticks_per_s(onlooked, ", pair " + std::to_string(pair) + " of " + std::to_string(kPairs)));
        (onlooked ? watched : alone).push_back(ticks_per_s);
      }
      ratios.push_back(watched.back() / alone.back());
    }
    figures_.add(name("watched", "alone_ticks_per_s"), median(alone));
    figures_.add(name("watched", "ticks_per_s"), median(watched));
    figures_.add(name("watched", "lowest_ratio"), *std::ranges::min_element(ratios));
    figures_.add(name("watched", "highest_ratio"), *std::ranges::max_element(ratios));
    figures_.add(name("watched", "ratio"), median(ratios), kWatchedRatio);
    return Done{};
  }

  Result<Done> realtime() {
    DdsRun plain = plain_;
    plain.common.clock = bus::ClockKind::kRealtime;
    plain.common.ticks = kRealtimeTicks;
    const auto alone = FARRIER_TRY(run_over_dds(robot_, titled(plain, "real time, alone")));
    DdsRun watched = titled(plain, "real time, recorded and monitored");
    watched.onlookers = {{.name = "record", .arguments = {"record", recording_}, .listens = "records domain"},
                         monitor_with_page()};
    const PageViewer viewer(watched.log_directory + "/monitor.log");
    const auto looked_on = FARRIER_TRY(run_over_dds(robot_, watched));
    const auto recorded = FARRIER_TRY(read_recording(recording_));
    const Recorded& all = recorded;
    const double MiB = static_cast<double>(std::filesystem::file_size(recording_)) / (1 << 20);
    figures_.add(name("record", "processor_percent"), 1e2 * looked_on.onlookers[0].processor_share, kRecordPercent);
    figures_.add(name("record", "samples_per_s"), all.samples / all.seconds);
    figures_.add(name("record", "MiB_per_s"), MiB / all.seconds);
    figures_.add(name("record", "lost_percent"), 1e2 * all.lost / (all.samples + all.lost));
    figures_.add(name("monitor", "processor_percent"), 1e2 * looked_on.onlookers[1].processor_share, kMonitorPercent);
    figures_.add(name("monitor", "frames_per_s"), viewer.frames_per_s());

    DdsRun ignored = titled(plain, "real time, ten monitors that stand still");
    for (int i = 0; i < kStoppedMonitors; ++i) {
      ignored.onlookers.push_back(monitor_with_page("stopped_" + std::to_string(i)));
      ignored.onlookers.back().stands_still = true;
    }
    const auto stopped = FARRIER_TRY(run_over_dds(robot_, ignored));
    const double before_s = alone.healths[participant::kSimBridge].latency_s[0];
    const double beside_s = stopped.healths[participant::kSimBridge].latency_s[0];
    figures_.add(name("stopped_monitors", "latency_p50_us"), 1e6 * beside_s);
    figures_.add(name("stopped_monitors", "alone_latency_p50_us"), 1e6 * before_s);
    figures_.add(name("stopped_monitors", "latency_p50_ratio"), beside_s / before_s, kStoppedLatencyRatio);
    return Done{};
  }

 private:
  Result<double> lockstep_ticks_per_s(bool onlooked, const std::string& which) {
    DdsRun run = titled(plain_, (onlooked ? "lock-step, recorded and monitored" : "lock-step, alone") + which);
    run.common.ticks = plain_.common.ticks / kOfTheTicks;
    std::optional<PageViewer> viewer;
    if (onlooked) {
      run.record_path = recording_;
      run.onlookers = {monitor_with_page()};
      viewer.emplace(run.log_directory + "/monitor.log");
    }
    const auto outcome = FARRIER_TRY(run_over_dds(robot_, run));
    return static_cast<double>(run.common.ticks) / outcome.wall_s;
  }

  DdsRun titled(DdsRun run, const std::string& what) const {
    run.title = vendor_ + ", " + what;
    return run;
  }
  std::string name(const char* of, const char* figure) const {
    return std::string("bench.") + of + "." + vendor_ + "." + figure;
  }

  const robot::Robot& robot_;
  DdsRun plain_;
  std::string vendor_;
  std::string recording_;
  report::Figures& figures_;
};

}  // namespace

Result<Done> bench_watched(const robot::Robot& robot, const DdsRun& plain, const std::string& out,
                           report::Figures& figures) {
  return VendorBench(robot, plain, out, figures).lockstep();
}

Result<Done> bench_beside(const robot::Robot& robot, const DdsRun& plain, const std::string& out,
                          report::Figures& figures) {
  return VendorBench(robot, plain, out, figures).realtime();
}

}  // namespace farrier::cli
