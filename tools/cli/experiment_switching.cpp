// farrier trot --experiment switching

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <optional>
#include <utility>

#include "lab/switching.hpp"
#include "robot/robot_builder.hpp"
#include "tools/cli/command.hpp"
#include "tools/cli/experiment.hpp"
#include "tools/report/html_page.hpp"

namespace farrier::cli {
namespace {

constexpr double kAdapting_s = 5.0;  ///< after the lead-in: gains have settled by then
constexpr int kStrides = 12;
constexpr int kStridesAtLeast = 10;
constexpr double kSteppedAtMost = 0.5;
constexpr double kBumpAtMost = 1e-12;  ///< of the nominal current: the rounding of sums that large

struct Slots {
  const char* name;
  supervisor::Design design;
};
constexpr Slots kOn{"switched", supervisor::Design::kPhases};
constexpr Slots kSwingGains{"swing_gains", supervisor::Design::kSwing};
constexpr Slots kStanceGains{"stance_gains", supervisor::Design::kStance};

struct Comparison {
  lab::TouchdownErrors on, swing_gains, stance_gains;
  double bump = 0.0;
};

double sum(const lab::TouchdownErrors& errors) {
  return std::accumulate(errors.integral_Ns.begin(), errors.integral_Ns.end(), 0.0);
}

/// Who knows the loads knows when they change, and need not be early.
robot::Robot switched_exactly(robot::Robot robot) {
  robot.safety.stance_lead_s = 0.0;
  return robot;
}

Result<robot::Robot> with_load_transfer(const robot::Robot& robot, double fraction) {
  robot::RobotFile file = robot.file;
  file.gait.load_transfer_fraction = fraction;
  auto built = robot::build_robot(std::move(file));
  if (!built) {
    return Error{config::to_string(built.error())};
  }
  return std::move(built).value();
}

Result<Comparison> compare(const robot::Robot& robot, const TrotOptions& options, const std::string& reference,
                           report::Outcome& outcome) {
  const auto ticks = [&](double duration_s) { return lab::ticks_of(duration_s, robot); };
  const Tick from = ticks(robot.plan.gait.lead_in_s + kAdapting_s);
  Comparison comparison;
  const auto measure = [&](const Slots& slots, lab::TouchdownErrors& errors) -> Result<Done> {
    lab::InprocRun settings;
    settings.ticks = from + ticks(kStrides / robot.plan.gait.frequency_Hz);
    settings.seed = options.seed;
    settings.design = slots.design;
    settings.announce = lab::Announce::kActual;
    const std::string name = reference + "_" + slots.name;
    auto ran = run_experiment(robot, settings, options.out + "/trace_" + name + ".csv", "switching " + name);
    if (!ran) {
      return ran.error();
    }
    add_failures(outcome, ran.value(), name);
    errors = lab::touchdown_errors(robot, ran.value().rows, from);
    const double bump = lab::largest_bump(robot, ran.value().rows, ran.value().result.gains);
    comparison.bump = comparison.bump >= bump ? comparison.bump : bump;
    return Done{};
  };
  for (auto&& [slots, errors] : {std::pair(kOn, &comparison.on), std::pair(kSwingGains, &comparison.swing_gains),
                                 std::pair(kStanceGains, &comparison.stance_gains)}) {
    if (auto measured = measure(slots, *errors); !measured) {
      return measured.error();
    }
  }
  return comparison;
}

void add_comparison(report::Figures& figures, const robot::Robot& robot, const Comparison& comparison,
                    const std::string& reference, std::optional<double> bound) {
  figures.add("trot.switching." + reference + "_ratio", sum(comparison.on) / sum(comparison.swing_gains), bound);
  figures.add("trot.switching." + reference + "_to_stance_ratio", sum(comparison.on) / sum(comparison.stance_gains));
  for (const robot::Joint& joint : robot.joints) {
    if (comparison.swing_gains.integral_Ns[joint.number] > 0.0) {
      figures.add("trot." + joint.name + ".switching_" + reference + "_ratio",
                  comparison.on.integral_Ns[joint.number] / comparison.swing_gains.integral_Ns[joint.number]);
    }
  }
}

}  // namespace

int run_switching(const robot::Robot& robot, const TrotOptions& options) {
  if (robot.plan.gait.pattern != gait::Pattern::kTrot ||
      robot.plan.gait.reference != gait::ReferenceKind::kLegKinematics) {
    std::fputs("farrier trot: --experiment switching is about touchdowns: give a robot with legs that trots\n", stderr);
    return kBadInput;
  }
  const auto steps = with_load_transfer(robot, 0.0);
  if (!steps) {
    std::fprintf(stderr, "farrier trot: %s\n", steps.error().message.c_str());
    return kBadInput;
  }
  report::Outcome outcome;
  outcome.command = "trot";
  outcome.run = report::run_info(robot, options.seed);
  const auto stepped = compare(switched_exactly(steps.value()), options, "stepped", outcome);
  if (!stepped) {
    return fail_experiment(stepped.error());
  }
  const auto ramped = compare(switched_exactly(robot), options, "ramped", outcome);
  if (!ramped) {
    return fail_experiment(ramped.error());
  }
  report::Figures& figures = outcome.figures;
  add_comparison(figures, robot, stepped.value(), "stepped", kSteppedAtMost);
  add_comparison(figures, robot, ramped.value(), "ramped", std::nullopt);
  figures.add("trot.switching.touchdowns", std::min(stepped.value().on.touchdowns, ramped.value().on.touchdowns),
              kStridesAtLeast);
  figures.add("trot.switching.bump", std::max(stepped.value().bump, ramped.value().bump), kBumpAtMost);
  const std::string head = report::page_head(robot.name + ": gains switched at touchdown", outcome);
  const auto page = report::write_page(options.out, head + report::page_foot(outcome));
  if (!page) {
    return fail_experiment(page.error());
  }
  return finish_experiment(outcome, options, page.value());
}

}  // namespace farrier::cli
