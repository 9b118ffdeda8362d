// Hubacher (2014), Figs 6.2 to 6.5 and C.2: least squares on the joint of Table A.1 while its load changes.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <utility>

#include "estimation/poles.hpp"
#include "thesis/rig/cycle_estimates.hpp"
#include "thesis/studies/registry.hpp"

namespace farrier::thesis {
namespace chapter6_signals_studies {
namespace {

constexpr double kForgetting = 0.85;  // 6.3: "all use"

/// A picture shows the run of the study's seed; a figure is the median of as many runs.
constexpr std::uint64_t kRuns = 15;

/// Estimates of a run, which depend on its opening and on the seed of its noise alone. Most claims and seeds share runs, so
/// each is made once and kept.
const CycleEstimates& estimates_of(const StudyContext& context, double opening, std::uint64_t run = 0) {
  static std::mutex one_at_a_time;
  static std::map<std::pair<double, std::uint64_t>, CycleEstimates> made;
  const std::lock_guard guard(one_at_a_time);
  const std::pair<double, std::uint64_t> key(opening, context.seed + run);
  auto place = made.find(key);
  if (place == made.end()) {
    const auto samples = thesis::drive(thesis::walking_cycle(), true, opening, key.second);
    place = made.try_emplace(key, samples, thesis::walking_cycle(), kForgetting).first;
  }
  return place->second;
}

/// Median of `value` over runs with a noise of their own.
template <class Value>
double over_runs(const StudyContext& context, double opening, const Value& value) {
  std::vector<double> values;
  for (std::uint64_t run = 0; run < kRuns; ++run) {
    values.push_back(value(estimates_of(context, opening, run)));
  }
  return median(std::move(values));
}

Picture bode_of(const CycleEstimates& estimates, const char* caption) {
  std::vector<std::vector<Panel>> columns;
  for (std::size_t section = 0; section < estimates.sections(); ++section) {
    columns.push_back(estimates.bode("to " + std::to_string((section + 1) * 250) + " ms", section));
  }
  return bode_picture(caption, std::move(columns));
}

// 6.2

constexpr ClaimSpec kIdealClaims[] = {
    {"6.2.section_1", "6.3.1",
     "When the system is not changing (column one), the estimates do not diverge from the truth and their variance is "
     "very low.",
     "Largest median error of the magnitude over the first section.", "dB", Relation::kAtMost, kConverged_dB},
    {"6.2.section_2", "6.3.1", "... converged within 50 ms.",
     "When the median error over 1 to 450 Hz of the magnitude falls below 2.15 dB, what the signs of the valve differ "
     "by, for the rest of the second section.",
     "ms", Relation::kAtMost, 50.0},
    {"6.2.section_3", "6.3.1", "The estimates of column three are converged after 60 ms ...",
     "The same, third section.", "ms", Relation::kAtMost, 60.0},
    {"6.2.section_4", "6.3.1", "... and those of column four after just 25 ms.", "The same, fourth section.", "ms",
     Relation::kAtMost, 25.0},
    {"6.2.aliasing", "6.3.1",
     "... the magnitude of the transfer function at the Nyquist frequency has not yet decayed.",
     "Third section's true magnitude at 500 Hz over that at 1 Hz.", "dB", Relation::kAtLeast, 0.0}};

Result<StudyResult> run_ideal(const StudyContext& context) {
  const auto converged = [&](std::size_t section) {
    return over_runs(context, thesis::kSmallOpening,
                     [&](const CycleEstimates& one) { return one.converged_ms(section); });
  };
  const CycleEstimates& shown = estimates_of(context, thesis::kSmallOpening);
  const Response at = shown.true_response(2, std::vector<double>{1.0, 499.999});
  StudyResult result;
  result.measured = {
      {"6.2.section_1",
       over_runs(context, thesis::kSmallOpening, [](const CycleEstimates& one) { return one.largest_error_dB(0); }),
       "median of 15 runs"},
      {"6.2.section_2", converged(1), "median of 15 runs"},
      {"6.2.section_3", converged(2), "median of 15 runs"},
      {"6.2.section_4", converged(3), "median of 15 runs"},
      {"6.2.aliasing", decibels(at)[1] - decibels(at)[0], ""}};
  result.pictures = {bode_of(shown, "White noise of 5 %: models every 5 ms, black to yellow; blue: the truth")};
  return result;
}

// 6.3

constexpr const char* kStability =
    "The second column reveals how close the complex conjugate poles come to the stability boundary.";

constexpr ClaimSpec kPoleClaims[] = {
    {"6.3.stability", "6.3.1", kStability,
     "Distance of the second section's true pair from the unit circle: a fortieth.", "1", Relation::kAtMost, 0.025},
    {"6.3.closer", "6.3.1", "... the poles are pushed closer to the stability boundary for increased mass ...",
     "That distance over the first section's.", "1", Relation::kBelow, 1.0},
    {"6.3.unstable", "6.3.1",
     "Thus, it can happen that the estimator returns a system with poles just slightly outside the stability boundary "
     "...",
     "Models of the second section with the pair outside, over 15 runs.", "1", Relation::kAtLeast, 1.0},
    {"6.3.third", "6.3.1",
     "Column three reveals more clearly that the estimator was not able to exactly estimate the poles ...",
     "Third section's last distance of the poles over the second section's.", "1", Relation::kAtLeast, 1.0}};

double pair_distance(const CycleEstimates& estimates, std::size_t section) {
  return 1.0 - std::abs(complex_pole(estimates.truth(section).a));
}

Result<StudyResult> run_poles(const StudyContext& context) {
  const CycleEstimates& shown = estimates_of(context, thesis::kSmallOpening);
  double outside = 0.0;
  std::vector<double> ratios;
  for (std::uint64_t run = 0; run < kRuns; ++run) {
    const CycleEstimates& one = estimates_of(context, thesis::kSmallOpening, run);
    for (const control::DiscreteModel& model : one.models(1)) {
      outside += std::abs(complex_pole(model.a)) > 1.0 ? 1.0 : 0.0;
    }
    const auto off = [&](std::size_t section) {
      return estimation::pole_distance<3>(estimation::poles<3>(one.models(section).back().a),
                                          estimation::poles<3>(one.truth(section).a));
    };
    ratios.push_back(off(2) / off(1));
  }
  StudyResult result;
  result.measured = {{"6.3.stability", pair_distance(shown, 1), ""},
                     {"6.3.closer", pair_distance(shown, 1) / pair_distance(shown, 0), ""},
                     {"6.3.unstable", outside, ""},
                     {"6.3.third", median(std::move(ratios)), "median of 15 runs"}};
  Picture picture{"Poles above, zeros below: black to yellow within the section; crosses: the truth", 4, {}};
  for (const bool zeros : {false, true}) {
    for (std::size_t section = 0; section < shown.sections(); ++section) {
      picture.panels.push_back(shown.plane(
          (zeros ? "zeros to " : "poles to ") + std::to_string((section + 1) * 250) + " ms", section, zeros));
    }
  }
  result.pictures = {std::move(picture)};
  return result;
}

// 6.4

constexpr ClaimSpec kMassClaims[] = {
    {"6.4.section_1", "6.3.1",
     "... once the estimated mass has converged, it does not diverge ... 0 s - 0.25 s or 0.3 s - 0.5 s.",
     "Largest error of the mass from 0 to 0.25 s.", "1", Relation::kAtMost, kConvergedMass},
    {"6.4.section_2", "6.3.1",
     "... once the estimated mass has converged, it does not diverge ... 0 s - 0.25 s or 0.3 s - 0.5 s.",
     "The same, from 0.3 to 0.5 s.", "1", Relation::kAtMost, kConvergedMass},
    {"6.4.superior", "6.3.1",
     "The estimation appears to be superior in case the system mass is increased, rather than decreased.",
     "Length of the mass's way over the distance it has to go, in the 60 ms after 0.25 s, over the same after 0.5 s.",
     "1", Relation::kBelow, 1.0},
    {"6.4.same_speed", "6.3.1",
     "... the convergence speed of the estimated mass compared to the convergence speed of the transfer function seems "
     "to be about the same.",
     "Largest difference over sections two to four of when the mass is within a twentieth and when the transfer "
     "function is within 2.15 dB.",
     "ms", Relation::kAtMost, 25.0},
    fails(
        "lambda 0.7 to 0.95, white noise of 1 and 20 % and ten other pairs of loads. From 0.5 to 1 kg 98 of 105 runs "
        "have such a peak; from 1.05 kg and more at most 4 have. The text does not print the loads",
        {"6.4.negative_peak", "6.3.1",
         "... the sharp negative peak visible in the estimated load mass just after the system dynamics have changed "
         "at 0.75 s.",
         "Least estimated mass in the 25 ms after 0.75 s, in which column four converges, over the true one: below 0.",
         "1", Relation::kBelow, 0.0})};

Result<StudyResult> run_mass(const StudyContext& context) {
  const auto over = [&](const auto& value) { return over_runs(context, thesis::kSmallOpening, value); };
  double slowest = 0.0;
  for (std::size_t section = 1; section < 4; ++section) {
    slowest = std::max(slowest, std::abs(over([&](const CycleEstimates& one) {
                         return one.mass_converged_ms(section) - one.converged_ms(section);
                       })));
  }
  const CycleEstimates& shown = estimates_of(context, thesis::kSmallOpening);
  StudyResult result;
  result.measured = {
      {"6.4.section_1", over([](const CycleEstimates& one) { return one.largest_mass_error(0, 0); }),
       "median of 15 runs"},
      {"6.4.section_2", over([](const CycleEstimates& one) { return one.largest_mass_error(1, 50); }),
       "median of 15 runs"},
      {"6.4.superior", over([](const CycleEstimates& one) { return one.mass_detour(1) / one.mass_detour(2); }),
       "median of 15 runs"},
      {"6.4.same_speed", slowest, "medians of 15 runs"},
      {"6.4.negative_peak", over([](const CycleEstimates& one) { return one.least_mass(3, 25); }),
       "median of 15 runs"}};
  result.pictures = {{"Load mass: of the model of each tick, and the truth", 1, {shown.mass_panel("")}}};
  return result;
}

// 6.5, C.2

constexpr ClaimSpec kFullClaims[] = {
    {"6.5.resonance", "6.3.2", "Therefore, the estimator is not able to identify the resonance peaks ...",
     "Share of the second section's models, from 60 ms on, whose resonance is more than 3 dB off the true one's "
     "height.",
     "1", Relation::kAtLeast, 0.5},
    {"6.5.blurred", "6.3.2",
     "... it is immediately evident that the estimator is no longer able to correctly identify the system dynamics.",
     "Mean error of the magnitude over the last 190 ms of all sections, over that of Fig. 6.2.", "1",
     Relation::kAtLeast, 2.0},
    {"6.5.variance", "6.3.2",
     "The nonlinearity and transient responses due to the high amplitude also increase the variance of the estimates.",
     "Spread of the magnitude from tick to tick, over that of Fig. 6.2.", "1", Relation::kAtLeast, 1.0}};

Result<StudyResult> run_full(const StudyContext& context) {
  const auto ratio = [&](const auto& value) {
    return over_runs(context, thesis::kFullOpening, value) / over_runs(context, thesis::kSmallOpening, value);
  };
  StudyResult result;
  result.measured = {
      {"6.5.resonance",
       over_runs(context, thesis::kFullOpening, [](const CycleEstimates& one) { return one.resonance_missed(1); }),
       "with 5 %: " + std::to_string(over_runs(context, thesis::kSmallOpening,
                                               [](const CycleEstimates& one) { return one.resonance_missed(1); }))},
      {"6.5.blurred", ratio([](const CycleEstimates& one) { return one.settled_error_dB(); }), ""},
      {"6.5.variance", ratio([](const CycleEstimates& one) { return one.settled_spread_dB(); }), ""}};
  result.pictures = {bode_of(estimates_of(context, thesis::kFullOpening),
                             "White noise of 100 %: models every 5 ms, black to yellow; blue: the truth")};
  return result;
}

constexpr const char* kTooFew =
    "... thus not exciting enough frequencies of the system dynamics to enable a good estimation.";

constexpr ClaimSpec kLowClaims[] = {
    {"C.2.error", "Fig. C.2", kTooFew,
     "Mean error of the magnitude over the last 190 ms of all sections, over that of Fig. 6.2.", "1",
     Relation::kAtLeast, 2.0},
    {"C.2.resonance", "Fig. C.2", kTooFew,
     "Share of the second section's models, from 60 ms on, whose resonance is more than 3 dB off the true one's "
     "height.",
     "1", Relation::kAtLeast, 0.5}};

Result<StudyResult> run_low(const StudyContext& context) {
  const CycleEstimates low{thesis::drive(thesis::walking_cycle(), false, thesis::kSmallOpening, context.seed),
                           thesis::walking_cycle(), kForgetting};
  const double rich =
      over_runs(context, thesis::kSmallOpening, [](const CycleEstimates& one) { return one.settled_error_dB(); });
  StudyResult result;
  result.measured = {{"C.2.error", low.settled_error_dB() / rich, ""}, {"C.2.resonance", low.resonance_missed(1), ""}};
  result.pictures = {bode_of(low, "Sines of 5 and 10 Hz of 5 %: models every 5 ms, black to yellow; blue: the truth")};
  return result;
}

constexpr const char* kIdentified =
    "Joint of Table A.1 without friction that sticks and without spool, perfect sensors. Least squares (6.21), lambda "
    "0.85, the "
    "operating point subtracted. The loads are ours, in the text's order. First covariance 0.14 I. Values are medians "
    "of 15 runs.";

constexpr Study kStudies[] = {
    {"6.2", "Estimated transfer functions, white noise of 5 %", kIdealClaims, run_ideal, kIdentified},
    {"6.3", "Estimated poles and zeros, white noise of 5 %", kPoleClaims, run_poles, kIdentified},
    {"6.4", "Estimated load mass, white noise of 5 %", kMassClaims, run_mass, kIdentified},
    {"6.5", "Estimated transfer functions, white noise of 100 %", kFullClaims, run_full, kIdentified},
    {"C.2", "Estimated transfer functions, two frequencies", kLowClaims, run_low, kIdentified}};

}  // namespace
}  // namespace chapter6_signals_studies

std::span<const Study> chapter6_signals() { return chapter6_signals_studies::kStudies; }

}  // namespace farrier::thesis
