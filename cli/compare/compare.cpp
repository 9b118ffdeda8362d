// farrier compare: one robot under several controllers, update logics or ways of switching, in process and in lock-step.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/base/help.hpp"
#include "cli/base/output_file.hpp"
#include "cli/compare/comparison.hpp"
#include "cli/trot/trot_run.hpp"
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
                                                        {"friction", run_friction},
                                                        {"body", run_body}};

int compare(CompareOptions o, RunComparison run) {
  if (o.estimators && run != run_body) {
    return refuse("compare", "--estimators is for compare body");
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
      app, "what", *run, kComparisons, "varied|controllers|update-logic|switching|noise|models|filters|friction|body",
      "varied: robots whose loads, supply, friction and valves are drawn and known to no controller, under "
      "adaptation, perfect knowledge and fixed controllers; controllers: every kind of them on such robots and "
      "on the rig whose load changes; update-logic: the four of the thesis on both; switching: the worth of "
      "gains that change at touchdown; noise: adaptation with better and with worse sensors; models: the "
      "rig's linear model, exact and as the thesis has it; filters: margins behind sensors that filter; friction: "
      "every kind of controller on contacts that stick, behind filters; body: every kind of controller under the whole "
      "robot on a ground, and what limits the best")
      ->required();
  declare_gait(app, *options);
  app.add_option("--estimator", options->estimator, "section of the robot file's estimators that every joint uses")
      ->type_name("<name>");
  app.add_option("--seeds", options->seeds, "robots that varied, controllers and noise draw, from --seed on")
      ->check(between(1, 10000))
      ->type_name("<n>")
      ->capture_default_str();
  app.add_flag(
      "--estimators", options->estimators,
      "body: estimators of a walking robot's joints and what adaptation does with them, in place of controllers");
  return [options, run] { return compare(*options, *run); };
}

}  // namespace farrier::cli
