#include "cli/trial/hide.hpp"

#include <unistd.h>

#include <cstdio>

#include "participant/loop.hpp"
#include "cli/base/command.hpp"
#include "cli/trial/hide_study.hpp"
#include "report/figures/console.hpp"
#include "report/figures/outcome.hpp"

namespace farrier::cli {
namespace {

int fail(const Error& error) {
  std::fprintf(stderr, "farrier trot --hide: %s\n", error.message.c_str());
  return participant::stop_requested() ? participant::stop_status() : kFailed;
}

}  // namespace

int hide(const robot::Robot& robot, const TrotOptions& o) {
  participant::install_signal_handlers();
  HideStudy study(robot, o);
  if (auto ran = study.run(); !ran) {
    return fail(ran.error());
  }
  report::Outcome outcome;
  outcome.command = "trot";
  outcome.run = report::run_info(robot, o.seed);
  report::add_hide(outcome.figures, study.trials());
  if (!study.long_enough()) {
    outcome.failures.emplace_back(kTooShort);
  }
  const std::string rows_path = o.out + "/hide.csv";
  if (auto written = report::write_hide_csv(rows_path, study.trials()); !written) {
    return fail(written.error());
  }
  if (auto written = report::write_json(o.json_path, outcome); !written) {
    return fail(written.error());
  }
  std::printf("%s\n%s", report::hide_text(study.trials()).c_str(),
              report::console_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str());
  for (const std::string& model : study.models()) {
    std::printf("extended model: %s\n", model.c_str());
  }
  std::printf("figures: %s\nevery joint and seed: %s\n", o.json_path.c_str(), rows_path.c_str());
  for (const std::string& recording : study.recordings()) {
    std::printf("recording: %s\n", recording.c_str());
  }
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace farrier::cli
