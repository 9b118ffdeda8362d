#include "trials/update_logic_study.hpp"

#include <chrono>
#include <span>

namespace farrier::trials {
namespace {

constexpr std::uint64_t kStudySession = 1;

void replay(supervisor::Supervisor& supervisor, std::span<const signals::JointModelEstimate> estimates,
            UpdateLogicRun& run) {
  const auto begin = std::chrono::steady_clock::now();
  for (std::size_t next = 0; next < estimates.size();) {
    const Tick tick = estimates[next].tick + 1;  // lock-step: those of tick k - 1 are worked on in tick k
    for (; next < estimates.size() && estimates[next].tick + 1 == tick; ++next) {
      supervisor.take(estimates[next], tick);
      ++run.looks;
    }
    run.accepted += supervisor.step(tick).gains.size();
  }
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begin;
  run.look_us = run.looks > 0 ? took.count() / static_cast<double>(run.looks) : 0.0;
  run.designs = supervisor.designs();
}

}  // namespace

Result<UpdateLogicRun> run_update_logic(robot::Robot robot, robot::UpdateMethod method, run::InprocRun settings) {
  robot.update_logic.method = method;
  UpdateLogicRun run;
  std::vector<signals::JointModelEstimate> estimates;
  settings.design = supervisor::Design::kAdaptive;
  settings.sink = [&](const trace::TraceRow& row) { run.rows.push_back(row); };
  settings.estimates = [&](const signals::JointModelEstimate& estimate) { estimates.push_back(estimate); };
  auto result = FARRIER_TRY(run::run_inproc(robot, settings));
  run.result = std::move(result);
  auto again = FARRIER_TRY(supervisor::Supervisor::create(robot, settings.design, robot.loop_delay_lockstep, kStudySession, {},
                                              settings.first_gains));
  again.step(0);  // arms
  replay(again, estimates, run);
  return run;
}

}  // namespace farrier::trials
