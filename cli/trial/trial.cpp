// farrier trial: diagnosis searches an effect that only the simulated robot has, in the recording of a run.

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "participant/loop.hpp"
#include "cli/base/help.hpp"
#include "cli/base/output_file.hpp"
#include "cli/trot/trot_run.hpp"
#include "cli/trot/trot_security.hpp"
#include "process/process.hpp"
#include "cli/trial/trial_study.hpp"
#include "report/figures/console.hpp"
#include "report/figures/outcome.hpp"

namespace farrier::cli {
namespace {

int trial(const robot::Robot& robot, const TrialOptions& o) {
  participant::install_signal_handlers();
  TrialStudy study(robot, o);
  if (auto ran = study.run(); !ran) {
    return fail("trial", ran.error().message);
  }
  report::Outcome outcome;
  outcome.command = "trial";
  outcome.run = report::run_info(robot, o.seed);
  report::add_hide(outcome.figures, study.trials());
  if (!study.long_enough()) {
    outcome.failures.emplace_back(kTooShort);
  }
  const std::string rows_path = o.out + "/hide.csv";
  if (auto written = report::write_hide_csv(rows_path, study.trials()); !written) {
    return fail("trial", written.error().message);
  }
  if (auto written = report::write_json(o.json_path, outcome); !written) {
    return fail("trial", written.error().message);
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

int prepare(TrialOptions o) {
  o.design = o.design.value_or(robot::Design::kAdaptive);
  const auto robot = process::load_robot(common_options(o));
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return kBadInput;
  }
  if (const robot::Joint* electric = robot.value().first_electric()) {
    return refuse("trial", "the effect is hidden in a hydraulic joint, and " + electric->name + " is electric: give another --robot");
  }
  if (auto secured = check_security(robot.value(), o); !secured) {
    return refuse("trial", secured.error().message);
  }
  const auto directory = OutputDirectory::claim(o.out);
  if (!directory) {
    return refuse("trial", directory.error().message);
  }
  o.out = std::filesystem::absolute(o.out).lexically_normal().string();
  std::filesystem::create_directories(o.out + "/log");
  o.trace_path = o.out + "/trace.csv";
  o.json_path = o.json_path.empty() ? o.out + "/figures.json" : o.json_path;
  o.record_path = o.record_path.empty() ? o.out + "/run.mcap" : o.record_path;
  if (auto way = make_way({o.trace_path, o.json_path, o.record_path}, {o.robot_path}); !way) {
    return refuse("trial", way.error().message);
  }
  return trial(robot.value(), o);
}

}  // namespace

std::function<int()> declare_trial(CLI::App& app) {
  auto options = std::make_shared<TrialOptions>();
  options->out = "out/trial";
  declare_gait(app, *options);
  declare_processes(app, *options);
  declare_control(app, *options);
  app.add_option("--hide", options->hide, "seed of the hidden effect: its joint, its kind and its size")
      ->check(between(0.0, 18446744073709551615.0))
      ->type_name("<seed>")
      ->capture_default_str();
  app.add_option("--seeds", options->seeds, "effects that are hidden in turn, from the seed of --hide on")
      ->check(between(1, 10000))
      ->type_name("<n>")
      ->capture_default_str();
  app.add_option("--record", options->record_path, "where the recording of the run goes")
      ->type_name("<file>")
      ->default_str("run.mcap in --out");
  return [options] { return prepare(*options); };
}

}  // namespace farrier::cli
