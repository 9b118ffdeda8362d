// farrier compare: one robot under several controllers, update logics or ways of switching, in process and in lock-step.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/base/help.hpp"
#include "cli/base/output_file.hpp"
#include "cli/compare/comparison.hpp"
#include "cli/trot/trot_run.hpp"
#include "participant/options.hpp"
#include "process/process.hpp"

namespace farrier::cli {
namespace {

using RunComparison = int (*)(const robot::Robot& robot, const CompareOptions& options);
const std::map<std::string, RunComparison> kComparisons{{"varied", run_varied},
                                                        {"controllers", run_controllers},
                                                        {"update-logic", run_update_logic},
                                                        {"switching", run_switching},
                                                        {"noise", run_noise},
                                                        {"models", run_models},
                                                        {"filters", run_filters},
                                                        {"bandwidth", run_bandwidth},
                                                        {"friction", run_friction},
                                                        {"body", run_body},
                                                        {"adaptation", run_adaptation}};

std::string names_of_comparisons() {
  std::string names;
  for (const auto& [name, run] : kComparisons) {
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

int compare(CompareOptions o, RunComparison run) {
  if (o.estimators && run != run_body) {
    return refuse("compare", "--estimators is for compare body");
  }
  const bool of_adaptation =
      !o.rows.empty() || !o.conditions.empty() || !o.designs.empty() || o.search || o.noise || o.go_on;
  if (of_adaptation && run != run_adaptation) {
    return refuse("compare",
                  "--rows, --conditions, --designs, --noise, --search and --continue are for compare adaptation");
  }
  o.design = robot::Design::kAdaptive;
  const auto robot = process::load_robot(common_options(o));
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return kBadInput;
  }
  if (const robot::Joint* electric = robot.value().first_electric()) {
    return refuse("compare",
                  "comparisons are of hydraulic joints, and " + electric->name + " is electric: give another --robot");
  }
  const auto directory = OutputDirectory::claim(o.out);
  if (!directory) {
    return refuse("compare", directory.error().message);
  }
  o.out = std::filesystem::absolute(o.out).lexically_normal().string();
  o.json_path = o.json_path.empty() ? o.out + "/figures.json" : o.json_path;
  if (auto way = make_way({o.json_path}, {o.robot_path}); !way) {
    return refuse("compare", way.error().message);
  }
  return run(robot.value(), o);
}

}  // namespace

std::function<int()> declare_compare(CLI::App& app) {
  auto options = std::make_shared<CompareOptions>();
  auto run = std::make_shared<RunComparison>(nullptr);
  options->out = "out/compare";
  add_choice(
      app, "what", *run, kComparisons,
      "varied|controllers|update-logic|switching|noise|models|filters|bandwidth|friction|body|adaptation",
      "varied: robots whose loads, supply, friction and valves are drawn and known to no controller, under "
      "adaptation, perfect knowledge and fixed controllers; controllers: every kind of them on such robots and "
      "on the rig whose load changes; update-logic: the four of the thesis on both; switching: the worth of "
      "gains that change at touchdown; noise: adaptation with better and with worse sensors; models: the "
      "rig's linear model, exact and as the thesis has it; filters: margins behind sensors that filter; "
      "bandwidth: frequencies up to which a held joint's force follows, by pose and amplitude; friction: "
      "every kind of controller on contacts that stick, behind filters; body: every kind of controller under the whole "
      "robot on a ground, and what limits the best; adaptation: plants that no design knows, under the whole robot "
      "with fixed designs, adaptation and perfect knowledge");
  declare_gait(app, *options);
  app.add_option("--estimator", options->estimator, "section of the robot file's estimators that every joint uses")
      ->type_name("<name>");
  app.add_option("--seeds", options->seeds,
                 "robots that varied, controllers and noise draw, from --seed on; runs of each cell of adaptation, and "
                 "twice as many and two more where fixed designs fall")
      ->check(between(1, 10000))
      ->type_name("<n>")
      ->capture_default_str();
  app.add_flag(
      "--estimators", options->estimators,
      "body: estimators of a walking robot's joints and what adaptation does with them, in place of controllers");
  const auto words = [&app](const char* name, std::vector<std::string>& into, const char* help) {
    app.add_option(name, into, help)->delimiter(',')->type_name("<names>");
  };
  words("--rows", options->rows, "adaptation: only these plants");
  words("--conditions", options->conditions, "adaptation: only these grounds and gaits: easy, fast, rough");
  words("--designs", options->designs,
        "adaptation: only these designs: nominal, tuned, observer, thesis, adaptive, perfect");
  app.add_flag(
      "--noise", options->noise,
      "adaptation: the adaptive design with 0, 10, 100 and 300 % of the sensors' noise, in place of the designs");
  app.add_flag("--search", options->search, "adaptation: search the designs tuned and observer, and print them");
  app.add_flag("--continue", options->go_on, "adaptation: go on with the runs in --out of one that was interrupted");
  app.add_option("--threads", options->threads, "adaptation: runs at a time")
      ->check(between(1, 256))
      ->type_name("<n>")
      ->capture_default_str();
  add_choice(app, "--world", options->world, participant::kWorlds, "body alone: compare adaptation on the whole robot");
  return [options, run, &app] {
    if (*run == nullptr && app.count("--world") > 0 && options->world == participant::World::kBody) {
      return compare(*options, run_adaptation);
    }
    if (*run == nullptr) {
      return refuse("compare", "no comparison is named: give one of " + names_of_comparisons());
    }
    if (app.count("--world") > 0) {
      return refuse("compare", "--world is for a comparison without a name: leave one of them out");
    }
    return compare(*options, *run);
  };
}

}  // namespace farrier::cli
