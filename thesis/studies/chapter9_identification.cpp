// Hubacher (2014), Figs 9.19 to 9.21: friction, springs and valve of the rig as its experiments identify them.

#include <algorithm>
#include <cmath>
#include <span>

#include "thesis/rig/rig_conditions.hpp"
#include "thesis/rig/rig_run.hpp"
#include "thesis/studies/registry.hpp"
#include "thesis/study/mean.hpp"

namespace farrier::thesis {
namespace chapter9_identification_studies {
namespace {

// 9.19

constexpr double kPercents[] = {2.0, 3.0, 5.0, 8.0, 12.0, 20.0};
constexpr double kFrom_m = 0.03;    // from mid-stroke, where a run begins
constexpr double kJudged_m = 0.02;  // within which the piston moves evenly

struct FrictionPoint {
  double velocity_m_s, force_N;
  double coefficient_Ns_m() const { return std::abs(force_N) / std::abs(velocity_m_s); }  // (9.6)
};

/// Mean velocity and force under a constant current, the springs removed.
Result<FrictionPoint> move_evenly(robot::Robot rig, double share, std::uint64_t seed) {
  rig.joints[0].swing_load.stiffness = 0.0;
  const double nominal_A = rig.joints[0].normalisation.current_A;
  // About 2 mm/s for each percent of opening beyond the deadband: long enough for the judged piece, and no longer.
  const double duration_s = 2.5 * kFrom_m / (0.0015 * (100.0 * std::abs(share) - 0.6));
  const auto run = drive(rig,
                         {.current_A = [=](double) { return share * nominal_A; },
                          .duration_s = duration_s,
                          .position_m = share > 0.0 ? -kFrom_m : kFrom_m},
                         seed);
  if (!run) {
    return run.error();
  }
  const RigTrace& r = run.value();
  const auto inside = [](double x) { return std::abs(x) < kJudged_m; };
  const auto first = std::ranges::find_if(r.position_m, inside);
  const auto last = std::find_if_not(first, r.position_m.end(), inside);
  if (first == last) {
    return Error{"Fig. 9.19: the piston did not reach the middle of its stroke"};
  }
  const auto begin = static_cast<std::size_t>(first - r.position_m.begin());
  const auto end = static_cast<std::size_t>(last - r.position_m.begin());
  return FrictionPoint{mean(std::span(r.measured_velocity_m_s).subspan(begin, end - begin)),
                       mean(std::span(r.measured_force_N).subspan(begin, end - begin))};
}

constexpr const char* kDependent =
    "As can be seen, the viscous friction coefficient is quite heavily velocity dependent.";

constexpr ClaimSpec kFrictionClaims[] = {
    {"9.19.dependent", "9.3.1", kDependent, "(9.6) at the lowest velocity over that at the highest: two.", "1",
     Relation::kAtLeast, 2.0},
    {"9.19.stribeck", "9.3.1", "It seems that there is Stribeck friction present at low velocities ...",
     "Force without its viscous part d_l v at the lowest velocity, less that at the highest.", "N", Relation::kAtLeast,
     1.0},
    needs(Condition::kViscousFriction,
          {"9.19.viscous", "9.3.1", "The coefficient of viscous friction is then calculated using d_l = |F_s| / |v|.",
           "Distance of (9.6) at the highest velocity from the rig's d_l, over it: a tenth.", "1", Relation::kAtMost,
           0.1}),
    proof({"9.19.slope", "9.3.1",
           "... the following expression for identifying the viscous friction coefficient is obtained ...",
           "Distance of the slope of force over velocity between the two highest velocities from the rig's d_l, over "
           "it: a "
           "tenth, as the "
           "proof of 9.19.viscous asks for.",
           "1", Relation::kAtMost, 0.1})};

Result<StudyResult> friction_of(const robot::Robot& rig, const StudyContext& context) {
  const double damping = rig.joints[0].swing_load.damping;
  Series there{"extending", {}, {}, Style::kPoints, 1};
  Series back{"retracting", {}, {}, Style::kPoints, 2};
  std::vector<FrictionPoint> points;
  for (const double percent : kPercents) {
    for (const double sign : {1.0, -1.0}) {
      const auto point = FARRIER_TRY(move_evenly(rig, sign * percent / 100.0, context.seed));
      Series& series = sign > 0.0 ? there : back;
      series.x.push_back(1e3 * std::abs(point.velocity_m_s));
      series.y.push_back(point.coefficient_Ns_m());
      if (sign > 0.0) {
        points.push_back(point);
      }
    }
    if (!keep_going(context, static_cast<double>(points.size()) / std::size(kPercents))) {
      return stopped();
    }
  }
  const FrictionPoint &slow = points.front(), &fast = points.back(), &second = points[points.size() - 2];
  const auto dry = [&](const FrictionPoint& p) { return p.force_N - damping * p.velocity_m_s; };
  const double slope = (fast.force_N - second.force_N) / (fast.velocity_m_s - second.velocity_m_s);
  StudyResult result;
  result.measured = {
      {"9.19.dependent", slow.coefficient_Ns_m() / fast.coefficient_Ns_m(),
       number_as("%.0f Ns/m at ", slow.coefficient_Ns_m()) + number_as("%.1f mm/s, ", 1e3 * slow.velocity_m_s) +
           number_as("%.0f Ns/m at ", fast.coefficient_Ns_m()) + number_as("%.1f mm/s", 1e3 * fast.velocity_m_s)},
      {"9.19.stribeck", dry(slow) - dry(fast),
       number_as("%.1f N at the lowest, ", dry(slow)) + number_as("%.1f N at the highest", dry(fast))},
      {"9.19.viscous", std::abs(fast.coefficient_Ns_m() / damping - 1.0), ""},
      {"9.19.slope", std::abs(slope / damping - 1.0), number_as("%.0f Ns/m", slope)}};
  Series truth{"d_l", {0.0, there.x.back()}, {damping, damping}, Style::kDashed, 5};
  result.pictures = {{"Friction coefficient of (9.6), springs removed",
                      1,
                      {{.title = "",
                        .x_label = "velocity (mm/s)",
                        .y_label = "|F_s| / |v| (Ns/m)",
                        .log_y = true,
                        .series = {std::move(there), std::move(back), std::move(truth)}}}}};
  return result;
}

Result<StudyResult> run_friction(const StudyContext& context) {
  const auto rig = FARRIER_TRY(load_rig(context));
  return measure_on(rig, kFrictionClaims, [&](const robot::Robot& robot) { return friction_of(robot, context); });
}

// 9.20

constexpr double kSprings = 4.0;
constexpr int kDataSets = 4;

constexpr const char* kStiffness =
    "The mean spring stiffness value for a single spring of about 5278 N/m is almost identical to the value ... [5360 "
    "N/m].";

constexpr ClaimSpec kSpringClaims[] = {{"9.20.mean", "9.3.2", kStiffness,
                                        "Distance of the mean over both ends and all data sets from the springs' "
                                        "stiffness, over it: 2 %, the text's own being 1.5 %.",
                                        "1", Relation::kAtMost, 0.02}};

/// Mean of |F_s| / |y| (9.7) at rest at one end, of a single spring.
Result<double> stiffness_at(const robot::Robot& rig, double sign, std::uint64_t seed) {
  const double nominal_A = rig.joints[0].normalisation.current_A;
  const auto run = drive(rig, {.current_A = [=](double) { return 0.2 * sign * nominal_A; }, .duration_s = 4.0}, seed);
  if (!run) {
    return run.error();
  }
  const std::size_t end = run.value().time_s.size();
  const std::size_t begin = end - 500;
  return std::abs(mean(std::span(run.value().measured_force_N).subspan(begin, end - begin))) /
         std::abs(mean(std::span(run.value().measured_position_m).subspan(begin, end - begin))) / kSprings;
}

Result<StudyResult> run_springs(const StudyContext& context) {
  const auto rig = FARRIER_TRY(load_rig(context));
  const double truth = rig.joints[0].swing_load.stiffness / kSprings;
  double sum = 0.0;
  Series ends[2] = {{"extended", {}, {}, Style::kPoints, 1}, {"retracted", {}, {}, Style::kPoints, 2}};
  for (int set = 0; set < kDataSets; ++set) {
    for (std::size_t end = 0; end < 2; ++end) {
      const double found =
          FARRIER_TRY(stiffness_at(rig, end == 0 ? 1.0 : -1.0, context.seed + static_cast<std::uint64_t>(set)));
      sum += found / (2.0 * kDataSets);
      ends[end].x.push_back(set + 1);
      ends[end].y.push_back(found);
    }
    if (!keep_going(context, static_cast<double>(set + 1) / kDataSets)) {
      return stopped();
    }
  }
  StudyResult result;
  result.measured = {
      {"9.20.mean", std::abs(sum / truth - 1.0), number_as("%.0f N/m", sum) + number_as(" of %.0f N/m", truth)}};
  const std::vector<double> across{0.5, kDataSets + 0.5};
  result.pictures = {{"Stiffness of a single spring, (9.7)",
                      1,
                      {{.title = "",
                        .x_label = "data set",
                        .y_label = "stiffness (N/m)",
                        .series = {std::move(ends[0]),
                                   std::move(ends[1]),
                                   {"springs of the rig", across, {truth, truth}, Style::kDashed, 5},
                                   {"mean", across, {sum, sum}, Style::kLine, 3}},
                        .y_range = report::Range{0.96 * truth, 1.04 * truth}}}}};
  return result;
}

// 9.21

constexpr double kRamp_percent_s = 1.0;
constexpr double kNoticed_Pa = 2e4;  // of 125 bar: what a pressure sensor of 0.16 % shows

constexpr const char* kThreshold = "The identified threshold is about 0.6 % of the valve opening ...";

constexpr ClaimSpec kThresholdClaims[] = {
    proof({"9.21.positive", "9.3.4", kThreshold,
           "Distance from 0.6 of the opening in % at which the load pressure begins to rise: 0.1.", "%",
           Relation::kAtMost, 0.1}),
    proof({"9.21.negative", "9.3.4", kThreshold, "The same of the negative opening at which it begins to fall.", "%",
           Relation::kAtMost, 0.1}),
    proof({"9.21.specification", "9.3.4",
           "... a threshold of 0.5 % - 1 % (in percentage of the valve opening) depending on the supply pressure.",
           "Distance of both from the middle of that range, the larger: 0.25.", "%", Relation::kAtMost, 0.25})};

Result<StudyResult> run_threshold(const StudyContext& context) {
  const auto rig = FARRIER_TRY(load_rig(context));
  const double nominal_A = rig.joints[0].normalisation.current_A;
  double found[2];
  Picture picture{"Slowly rising and falling valve input; crosses: the load pressure begins to change", 2, {}};
  for (std::size_t k = 0; k < 2; ++k) {
    const double sign = k == 0 ? 1.0 : -1.0;
    const auto made = drive(
        rig, {.current_A = [=](double t) { return sign * 0.01 * kRamp_percent_s * t * nominal_A; }, .duration_s = 1.2},
        context.seed);
    if (!made) {
      return made.error();
    }
    const RigTrace& run = made.value();
    const auto changed = std::ranges::find_if(
        run.load_pressure_Pa, [&](double p) { return sign * (p - run.load_pressure_Pa[0]) > kNoticed_Pa; });
    const std::size_t at =
        std::min<std::size_t>(static_cast<std::size_t>(changed - run.load_pressure_Pa.begin()), run.time_s.size() - 1);
    found[k] = 100.0 * std::abs(run.current_A[at]) / nominal_A;
    const std::vector<double> opening = scaled(run.current_A, 100.0 / nominal_A);
    picture.panels.push_back(
        {.title = sign > 0.0 ? "rising" : "falling",
         .x_label = "valve input (%)",
         .y_label = "pressure (bar)",
         .series = {{"p_a", opening, scaled(run.pressure_a_Pa, 1e-5), Style::kLine, 1},
                    {"p_b", opening, scaled(run.pressure_b_Pa, 1e-5), Style::kLine, 2},
                    {"threshold", {opening[at]}, {1e-5 * run.pressure_a_Pa[at]}, Style::kCrosses, 3}}});
  }
  StudyResult result;
  result.measured = {{"9.21.positive", std::abs(found[0] - 0.6), number_as("%.2f %%", found[0])},
                     {"9.21.negative", std::abs(found[1] - 0.6), number_as("%.2f %%", found[1])},
                     {"9.21.specification", std::max(std::abs(found[0] - 0.75), std::abs(found[1] - 0.75)), ""}};
  result.pictures = {std::move(picture)};
  return result;
}

constexpr Study kStudies[] = {{"9.19", "Friction coefficient over velocity", kFrictionClaims, run_friction, kOnTheRig},
                              {"9.20", "Stiffness of the springs", kSpringClaims, run_springs, kOnTheRig},
                              {"9.21", "Threshold of the valve", kThresholdClaims, run_threshold, kOnTheRig}};

}  // namespace
}  // namespace chapter9_identification_studies

std::span<const Study> chapter9_identification() { return chapter9_identification_studies::kStudies; }

}  // namespace farrier::thesis
