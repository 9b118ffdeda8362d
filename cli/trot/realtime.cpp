#include "cli/trot/realtime.hpp"

#include <algorithm>
#include <vector>

#include "cli/trot/in_process.hpp"
#include "cli/trot/trot_run.hpp"
#include "report/figures/run_info.hpp"

namespace farrier::cli {
namespace {

using namespace std::chrono_literals;

constexpr auto kTimerLoop = 2s;
constexpr double kExchange_s = 3.0;

// Bounds of a run on a computer that keeps up: latency over the bare exchange's, stance NRMSE over that of a lock-step
// run.
constexpr double kLatencyRatio = 1.5;
constexpr double kNrmseRatio = 1.25;

/// Median over joints of one run's stance NRMSE over another's.
double median_ratio(const report::Tracking& of, const report::Tracking& over) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < of.joints.size(); ++i) {
    ratios.push_back(of.joints[i].stance.nrmse / over.joints[i].stance.nrmse);
  }
  std::ranges::nth_element(ratios, ratios.begin() + std::ssize(ratios) / 2);
  return ratios[ratios.size() / 2];
}

}  // namespace

Result<Yardstick> measure_yardstick(const robot::Robot& robot, const TrotOptions& options) {
  const auto period = std::chrono::duration_cast<Nanoseconds>(std::chrono::duration<double>(robot.period_s));
  Yardstick yardstick{bench::bare_timer_loop(period, kTimerLoop), {}};
  DdsRun run = dds_run(robot, options, "trot, bare exchange");
  run.common.ticks = run::ticks_of(kExchange_s, robot);
  run.log_directory = options.out + "/log/bare_exchange";
  run.bare = true;
  auto exchange = FARRIER_TRY(run_over_dds(robot, run));
  yardstick.exchange = std::move(exchange);
  return yardstick;
}

Result<Done> add_realtime(report::Outcome& outcome, const robot::Robot& robot, const TrotOptions& options,
                          const Yardstick& yardstick, const report::Tracking& tracking) {
  report::Figures& figures = outcome.figures;
  const bench::TimerLoop& timer = yardstick.timer;
  report::ProcessInfo alone;
  alone.periods = timer.periods;
  alone.missed_periods = timer.missed;
  alone.wake_up_s = timer.wake_up_s;
  report::add_latencies(figures, "trot.bare_timer", {alone});
  const RunOutcome& exchange = yardstick.exchange;
  report::add_latencies(figures, "trot.bare_exchange", report::process_infos(exchange.hellos, exchange.healths));
  const report::Figure* missed = figures.find("trot.missed_periods");
  for (const char* alone_too : {"trot.bare_timer.missed_periods", "trot.bare_exchange.missed_periods"}) {
    const report::Figure* bare_missed = figures.find(alone_too);
    if (missed != nullptr && bare_missed != nullptr && bare_missed->value > missed->bound) {
      outcome.warnings.push_back(std::string(alone_too) +
                                 ": beyond the bound of trot.missed_periods with nothing else running; "
                                 "this computer, as it is now, does not allow what is asked");
    }
  }
  const report::Figure* latency = figures.find("trot.latency_p99_us");
  const report::Figure* bare_latency = figures.find("trot.bare_exchange.latency_p99_us");
  if (latency == nullptr || bare_latency == nullptr) {
    return Error{"no valve command came back to sim_bridge: see the logs in " + options.out + "/log"};
  }
  figures.add("trot.latency_p99_ratio", latency->value / bare_latency->value, kLatencyRatio);

  robot::Robot delayed = robot;
  delayed.loop_delay_lockstep = robot.loop_delay_realtime;
  const std::string path = options.out + "/trace_lockstep.csv";
  auto ran = FARRIER_TRY(
      run_in_process(delayed, options, options.design.value(), path, "trot, lock-step with the same delay"));
  const auto lockstep = FARRIER_TRY(tracking_of(delayed, ran, path, options.seed, delayed.loop_delay_lockstep));
  figures.add("trot.realtime_nrmse_ratio", median_ratio(tracking, lockstep), kNrmseRatio);
  return Done{};
}

}  // namespace farrier::cli
