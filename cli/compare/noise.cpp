// farrier compare noise: adaptation with worse and better sensors than the robot file has.

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "cli/base/command.hpp"
#include "cli/base/installation.hpp"
#include "cli/base/progress.hpp"
#include "cli/compare/comparison.hpp"
#include "cli/compare/varied_study.hpp"
#include "core/median.hpp"
#include "participant/loop.hpp"
#include "report/compare/noise.hpp"
#include "report/figures/console.hpp"
#include "robot/sensor_path.hpp"
#include "trials/load_cycle.hpp"

namespace farrier::cli {
namespace {

using report::Contender;
using report::NoiseLevel;
using report::RigNoise;

constexpr std::array kOnTrot{Contender::kAdaptive, Contender::kPerfect, Contender::kGreyBox};
constexpr std::array kOnRig{trials::kAdaptiveCase, trials::kTrueLoadCase, trials::kGreyBoxCase};

/// The load cycle of Fig. 7.8 under one case.
Result<RigNoise> load_steps(const trials::LoadCycle& cycle, const trials::LoadCycleCase& one, double factor,
                            std::uint64_t seed) {
  const robot::Robot robot = robot::with_noise(trials::robot_of(cycle, one), factor);
  const auto errors = FARRIER_TRY(run_load_cycle(cycle, robot, trials::run_of(cycle, one, seed)));
  return RigNoise{.heavy = errors.heavy, .light = errors.light};
}

Result<Done> add_rig(const trials::LoadCycle& cycle, const CompareOptions& o, Progress& progress, Tick& done,
                     NoiseLevel& level) {
  for (int i = 0; i < o.seeds; ++i) {
    std::array<RigNoise, kOnRig.size()> runs;
    for (std::size_t j = 0; j < kOnRig.size(); ++j) {
      runs[j] = FARRIER_TRY(load_steps(cycle, kOnRig[j], level.factor.value, o.seed + static_cast<std::uint64_t>(i)));
      progress.update(++done);
    }
    level.rig.push_back({.linear = runs[0], .true_gains = runs[1], .grey_box = runs[2]});
  }
  return Done{};
}

Result<Done> add_trot(const robot::Robot& robot, const CompareOptions& o, NoiseLevel& level) {
  const robot::Robot nominal = robot::with_noise(trials::with_varied_body(robot), level.factor.value);
  VariedStudy study(nominal, kOnTrot, o, std::string("compare noise, trots, noise ") + level.factor.name);
  FARRIER_TRY(study.run());
  if (!study.long_enough()) {
    return Error{kTooShort};
  }
  const auto median_of = [&](Contender contender) {
    std::vector<double> errors;
    for (const report::VaryRow& row : study.rows()) {
      if (row.contender == contender) {
        errors.push_back(row.stance_nrmse);
      }
    }
    return median(std::move(errors));
  };
  level.trot = {.linear = median_of(Contender::kAdaptive),
                .perfect = median_of(Contender::kPerfect),
                .grey_box = median_of(Contender::kGreyBox)};
  return Done{};
}

Result<std::vector<NoiseLevel>> levels_of(const robot::Robot& robot, const CompareOptions& o) {
  robot::Overrides overrides;
  if (!o.estimator.empty()) {
    overrides.estimator = o.estimator;
  }
  const auto rig = robot::load_robot(shipped_robot("fc1d.yaml"), overrides);
  if (!rig) {
    return Error{config::to_string(rig.error())};
  }
  const auto cycle = FARRIER_TRY(trials::make_load_cycle(rig.value()));
  std::vector<NoiseLevel> levels;
  Tick done = 0;
  {
    Progress progress("compare noise, load steps",
                      static_cast<Tick>(report::kNoiseFactors.size() * kOnRig.size()) * o.seeds);
    for (const report::NoiseFactor& factor : report::kNoiseFactors) {
      levels.push_back({.factor = factor, .rig = {}, .trot = {}});
      FARRIER_TRY(add_rig(cycle, o, progress, done, levels.back()));
    }
  }
  for (NoiseLevel& level : levels) {
    FARRIER_TRY(add_trot(robot, o, level));
  }
  return levels;
}

}  // namespace

int run_noise(const robot::Robot& robot, const CompareOptions& options) {
  participant::install_signal_handlers();
  const auto levels = levels_of(robot, options);
  if (!levels) {
    return fail("compare", levels.error().message);
  }
  report::Outcome outcome;
  outcome.command = "compare";
  outcome.run = report::run_info(robot, options.seed);
  report::add_noise(outcome.figures, levels.value());
  if (auto written = report::write_json(options.json_path, outcome); !written) {
    return fail("compare", written.error().message);
  }
  std::printf("%s\n%s", report::noise_text(levels.value()).c_str(),
              report::console_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str());
  std::printf("figures: %s\n", options.json_path.c_str());
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace farrier::cli
