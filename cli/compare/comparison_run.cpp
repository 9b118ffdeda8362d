#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "participant/loop.hpp"
#include "cli/base/command.hpp"
#include "cli/compare/comparison.hpp"
#include "cli/base/progress.hpp"
#include "report/figures/console.hpp"

namespace farrier::cli {

Result<CycleErrors> run_load_cycle(const trials::LoadCycle& cycle, const robot::Robot& believed, run::InprocRun run) {
  std::vector<trace::TraceRow> trace;
  run.sink = [&](const trace::TraceRow& row) { trace.push_back(row); };
  run.progress = [](Tick) { return !participant::stop_requested(); };
  FARRIER_TRY(run::run_inproc(believed, run));
  const auto error = [&](std::size_t quarter) { return trials::quarter_error(cycle, trace, quarter); };
  return CycleErrors{.heavy = std::max(error(1), error(3)), .light = std::max(error(0), error(2))};
}

Result<ComparedRun> run_compared(const robot::Robot& robot, run::InprocRun run, const std::string& trace_path,
                                 const std::string& title) {
  participant::install_signal_handlers();
  Progress progress(title, run.ticks);
  run.trace_path = trace_path;
  std::vector<trace::TraceRow> rows;
  run.sink = [&rows](const trace::TraceRow& row) { rows.push_back(row); };
  run.progress = [&](Tick tick) {
    progress.update(tick);
    return !participant::stop_requested();
  };
  auto result = FARRIER_TRY(run::run_inproc(robot, run));
  return ComparedRun{std::move(rows), std::move(result)};
}

void add_failures(report::Outcome& outcome, const ComparedRun& run, const std::string& title) {
  for (const signals::SystemEvent& event : run.result.events) {
    if (event.severity == signals::Severity::kError) {
      outcome.failures.push_back(title + ": " + std::string(signals::text_of(event.text)));
    }
  }
}

int finish_comparison(const report::Outcome& outcome, const CompareOptions& options, const std::string& page) {
  if (auto written = report::write_json(options.json_path, outcome); !written) {
    return fail("compare", written.error().message);
  }
  std::fputs(report::console_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str(), stdout);
  std::printf("report: %s\nfigures: %s\n", page.c_str(), options.json_path.c_str());
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace farrier::cli
