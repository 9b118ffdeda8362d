// farrier trial hide: diagnosis searches an effect that only the simulated robot has, in the recording of a run.
// farrier trial body: a whole robot trots over a simulated ground (body_trial.cpp).

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <set>

#include "core/text.hpp"
#include "participant/loop.hpp"
#include "cli/base/help.hpp"
#include "cli/base/output_file.hpp"
#include "cli/trot/trot_run.hpp"
#include "cli/trot/trot_security.hpp"
#include "process/process.hpp"
#include "cli/trial/body_trial.hpp"
#include "cli/trial/controller_study.hpp"
#include "cli/trial/trial_study.hpp"
#include "report/figures/console.hpp"
#include "report/figures/outcome.hpp"
#include "trials/body/trot_cases.hpp"

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
    return refuse("trial", "the effect is hidden in a hydraulic joint, and " + electric->name +
                               " is electric: give another --robot");
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
  return o.controllers ? run_controller_study(robot.value(), o) : trial(robot.value(), o);
}

enum class What { kHide, kBody };
const std::map<std::string, What> kTrials{{"hide", What::kHide}, {"body", What::kBody}};

/// Names of options on the command line that are for the other trial. An environment variable is for both.
std::string strange_options(const CLI::App& app, What what) {
  const std::set<std::string> of_both{"what", "robot", "out", "json", "help"};
  const std::set<std::string> of_body{"ideal", "only", "smoke", "threads", "continue"};
  std::string strange;
  for (const CLI::Option* option : app.get_options()) {
    const std::string name = option->get_single_name();
    const bool by_environment = !option->get_envname().empty() && std::getenv(option->get_envname().c_str()) != nullptr;
    if (option->count() > 0 && !by_environment && !of_both.contains(name) &&
        of_body.contains(name) != (what == What::kBody)) {
      strange += (strange.empty() ? "--" : ", --") + name;
    }
  }
  return strange;
}

void declare_body(CLI::App& app, BodyTrialOptions& o) {
  std::vector<std::string> names;
  for (const trials::TrotTrial& trial : trials::kTrotTrials) {
    names.emplace_back(trial.name);
  }
  app.add_option("--only", o.only, "body: trials, of " + join(names, ", "))
      ->delimiter(',')
      ->check(CLI::IsMember(names))
      ->type_name("<names>")
      ->default_str("all");
  app.add_flag("--smoke", o.smoke, "body: the first run of each trial but push_limit, in half a minute")->type_name("");
  app.add_flag("--ideal", o.ideal, "body: the joints follow their torques at once, in place of their actuators")
      ->type_name("");
  app.add_option("--threads", o.threads, "body: runs at a time")
      ->check(between(1, 256))
      ->type_name("<n>")
      ->capture_default_str();
  app.add_flag("--continue", o.go_on,
               "body: takes over the runs that an interrupted trial of the same build and robot kept beside --json")
      ->type_name("");
}

int run_trial(const CLI::App& app, What what, const TrialOptions& o, BodyTrialOptions body) {
  if (const std::string strange = strange_options(app, what); !strange.empty()) {
    const char* other = what == What::kBody ? "farrier trial hide" : "farrier trial body";
    return refuse("trial", strange + " is for " + other);
  }
  if (what == What::kHide) {
    return prepare(o);
  }
  body.robot_path = o.robot_path;
  body.out = o.out;
  body.json_path = o.json_path;
  return run_body_trials(body);
}

}  // namespace

std::function<int()> declare_trial(CLI::App& app) {
  auto options = std::make_shared<TrialOptions>();
  auto body = std::make_shared<BodyTrialOptions>();
  auto what = std::make_shared<What>(What::kHide);
  options->out = "out/trial";
  add_choice(app, "what", *what, kTrials, "hide|body",
             "hide: an effect is hidden in one joint, and diagnosis must name it; body: the whole robot, by its own "
             "state estimate, trots on flat and rough ground, under pushes, payload and lag")
      ->default_str("hide");
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
  app.add_flag("--controllers", options->controllers,
               "diagnose the hidden joint under every kind of controller, in one process: names must be the same and "
               "sizes within 5 %")
      ->type_name("");
  app.add_option("--record", options->record_path, "where the recording of the run goes")
      ->type_name("<file>")
      ->default_str("run.mcap in --out");
  declare_body(app, *body);
  return [&app, options, body, what] { return run_trial(app, *what, *options, *body); };
}

}  // namespace farrier::cli
