// farrier compare switching

#include <algorithm>
#include <cstdio>
#include <cmath>
#include <numeric>
#include <optional>

#include "trials/switching.hpp"
#include "robot/robot_builder.hpp"
#include "cli/base/command.hpp"
#include "cli/compare/comparison.hpp"
#include "cli/trot/in_process.hpp"
#include "report/page/html_page.hpp"

namespace farrier::cli {
namespace {

constexpr double kAdapting_s = 9.0;  ///< as long as farrier trot
constexpr int kStridesFirst = 2;     ///< not judged: the robot gets into its stride
constexpr int kStrides = 12;
constexpr int kTouchdownsAtLeast = 11;  ///< ten strides lie between them
constexpr double kSteppedAtMost = 0.5;
constexpr double kBumpAtMost = 1e-12;  ///< of the nominal current: the rounding of sums that large

using Gains = std::vector<supervisor::SlotGains>;

struct Comparison {
  trials::TouchdownErrors on, swing_gains, stance_gains;
  double bump = 0.0;
};

// NaN when one of them is: a run that could not be replayed shall not pass.
double larger(double a, double b) { return std::isnan(a) || a >= b ? a : b; }

double sum(const trials::TouchdownErrors& errors) {
  return std::accumulate(errors.integral_Ns.begin(), errors.integral_Ns.end(), 0.0);
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

/// Returns the gains to which adaptation leads on this gait.
Result<Gains> adapt(const robot::Robot& robot, const CompareOptions& options, report::Outcome& outcome) {
  run::InprocRun settings;
  settings.ticks = run::ticks_of(kAdapting_s, robot);
  settings.seed = options.seed;
  settings.design = supervisor::Design::kAdaptive;
  auto ran = FARRIER_TRY(run_compared(robot, settings, options.out + "/trace_adapting.csv", "switching adapting"));
  add_failures(outcome, ran, "adapting");
  const auto& gains = ran.result.gains;
  outcome.figures.add("trot.switching.gain_updates",
                      static_cast<double>(gains.size() - signals::kPhaseCount * robot.joints.size()));
  return trials::last_gains(robot, gains);
}

Result<Comparison> compare(const robot::Robot& robot, const Gains& adapted, const CompareOptions& options,
                           const std::string& reference, report::Outcome& outcome) {
  const double stride_s = 1.0 / robot.plan.gait.frequency_Hz;
  const Tick from = run::ticks_of(robot.plan.gait.lead_in_s + kStridesFirst * stride_s, robot);
  Comparison comparison;
  const auto measure = [&](const char* slots, const Gains& gains, trials::TouchdownErrors& errors) -> Result<Done> {
    run::InprocRun settings;
    settings.ticks = from + run::ticks_of(kStrides * stride_s, robot);
    settings.seed = options.seed;
    settings.first_gains = gains;
    const std::string name = reference + "_" + slots;
    auto ran = FARRIER_TRY(run_compared(robot, settings, options.out + "/trace_" + name + ".csv", "switching " + name));
    add_failures(outcome, ran, name);
    errors = trials::touchdown_errors(robot, ran.rows, from);
    const double bump = trials::largest_bump(robot, ran.rows, ran.result.gains);
    comparison.bump = larger(comparison.bump, bump);
    return Done{};
  };
  FARRIER_TRY(measure("switched", adapted, comparison.on));
  const Gains swing = trials::in_both_slots(adapted, signals::Phase::kSwing);
  FARRIER_TRY(measure("swing_gains", swing, comparison.swing_gains));
  const Gains stance = trials::in_both_slots(adapted, signals::Phase::kStance);
  FARRIER_TRY(measure("stance_gains", stance, comparison.stance_gains));
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

int run_switching(const robot::Robot& robot, const CompareOptions& options) {
  if (robot.plan.gait.pattern != gait::Pattern::kTrot ||
      robot.plan.gait.reference != gait::ReferenceKind::kLegKinematics) {
    std::fputs("farrier compare: switching is about touchdowns: give a robot with legs that trots\n", stderr);
    return kBadInput;
  }
  const auto steps = with_load_transfer(robot, 0.0);
  if (!steps) {
    std::fprintf(stderr, "farrier compare: %s\n", steps.error().message.c_str());
    return kBadInput;
  }
  report::Outcome outcome;
  outcome.command = "compare";
  outcome.run = report::run_info(robot, options.seed);
  const auto adapted = adapt(robot, options, outcome);
  if (!adapted) {
    return fail("compare", adapted.error().message);
  }
  const auto stepped = compare(without_dither(steps.value()), adapted.value(), options, "stepped", outcome);
  if (!stepped) {
    return fail("compare", stepped.error().message);
  }
  const auto ramped = compare(without_dither(robot), adapted.value(), options, "ramped", outcome);
  if (!ramped) {
    return fail("compare", ramped.error().message);
  }
  report::Figures& figures = outcome.figures;
  add_comparison(figures, robot, stepped.value(), "stepped", kSteppedAtMost);
  add_comparison(figures, robot, ramped.value(), "ramped", std::nullopt);
  figures.add("trot.switching.touchdowns", std::min(stepped.value().on.touchdowns, ramped.value().on.touchdowns),
              kTouchdownsAtLeast);
  figures.add("trot.switching.bump", larger(stepped.value().bump, ramped.value().bump), kBumpAtMost);
  const std::string head = report::page_head(robot.name + ": gains switched at touchdown", outcome);
  const auto page = report::write_page(options.out, head + report::page_foot(outcome));
  if (!page) {
    return fail("compare", page.error().message);
  }
  return finish_comparison(outcome, options, page.value());
}

}  // namespace farrier::cli
