#include "cli/trot/trot_security.hpp"

#include <algorithm>

#include "process/process.hpp"
#include "cli/trot/trot_run.hpp"

namespace farrier::cli {
namespace {

constexpr double kSecuredLatencyRatio = 2.5;
constexpr double kRun_s = 2.0;
/// Others may use the computer meanwhile: of as many runs each, the least disturbed is taken.
constexpr int kTurns = 3;

/// Median time from a sensor sample to the valve command that answers it, in s.
Result<double> median_latency(const robot::Robot& robot, const TrotOptions& options, const std::string& title) {
  DdsRun run = dds_run(robot, options, title);
  run.common.ticks = run::ticks_of(kRun_s, robot);
  run.common.trace_path.clear();
  run.record_path.clear();
  run.log_directory = options.out + (options.security.empty() ? "/log/open" : "/log/secure");
  const auto ran = FARRIER_TRY(run_over_dds(robot, run));
  const double median = ran.healths[participant::kSimBridge].latency_s[0];
  if (!(median > 0.0)) {
    return Error{"no valve command came back to sim_bridge: see the logs in " + run.log_directory};
  }
  return median;
}

}  // namespace

Result<Done> check_security(const robot::Robot& robot, const TrotOptions& options) {
  if (options.security.empty()) {
    return options.security_cost
               ? Result<Done>(Error{"--security-cost compares with what --security gives: name its folder"})
               : Done{};
  }
  if (options.dds == DdsChoice::kInproc) {
    return Error{"--security is for processes that talk over DDS; --dds inproc runs in one: leave it out"};
  }
  bus::NetworkOptions unused;
  for (const run::Member& member : run::plan_processes(robot, grouping_of(options), options.standby)) {
    auto secured = process::secure(unused, options.security, run::role_of(member), vendor_of(options.dds, member));
    if (!secured) {
      return secured;
    }
  }
  return Done{};
}

Result<Done> add_security_cost(const robot::Robot& robot, const TrotOptions& options, report::Figures& figures) {
  TrotOptions open = options;
  open.security.clear();
  double best_open_s = 0.0;
  double best_secure_s = 0.0;
  for (int turn = 0; turn < kTurns; ++turn) {
    const auto without = FARRIER_TRY(median_latency(robot, open, "trot, open"));
    const auto with = FARRIER_TRY(median_latency(robot, options, "trot, secure"));
    best_open_s = turn == 0 ? without : std::min(best_open_s, without);
    best_secure_s = turn == 0 ? with : std::min(best_secure_s, with);
  }
  figures.add("trot.security.open_latency_p50_us", best_open_s * 1e6);
  figures.add("trot.security.latency_p50_us", best_secure_s * 1e6);
  figures.add("trot.security.latency_p50_ratio", best_secure_s / best_open_s, kSecuredLatencyRatio);
  return Done{};
}

}  // namespace farrier::cli
