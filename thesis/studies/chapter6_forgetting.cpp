// Hubacher (2014), Figs 6.6 and 6.7: least squares that starts from 10.5 kg on a joint that carries 105 kg, by its
// forgetting factor.

#include <array>
#include <cmath>

#include "thesis/rig/cycle_estimates.hpp"
#include "thesis/studies/registry.hpp"

namespace farrier::thesis {
namespace chapter6_forgetting_studies {
namespace {

constexpr std::array kForgetting{0.8, 0.85, 0.9, 0.98};
constexpr Tick kLength = 150;   // T_sim
constexpr Tick kSettled = 100;  // by then all but the last have converged
constexpr std::uint64_t kRuns = 15;

CycleEstimates estimates_of(const StudyContext& context, double forgetting, std::uint64_t run = 0) {
  const std::array loads{thesis::cycle_load(thesis::kHeavyLoad_kg)};
  return {thesis::drive(loads, true, thesis::kSmallOpening, context.seed + run), loads, forgetting};
}

template <class Value>
double over_runs(const StudyContext& context, double forgetting, const Value& value) {
  std::vector<double> values;
  for (std::uint64_t run = 0; run < kRuns; ++run) {
    values.push_back(value(estimates_of(context, forgetting, run)));
  }
  return median(std::move(values));
}

double mass_ms(const StudyContext& context, double forgetting) {
  return over_runs(context, forgetting, [](const CycleEstimates& one) { return one.mass_converged_ms(0, kLength); });
}

double spread_dB(const StudyContext& context, double forgetting) {
  return over_runs(context, forgetting,
                   [](const CycleEstimates& one) { return one.settled_spread_dB(kSettled, kLength); });
}

std::string title_of(double forgetting) { return "forgetting factor " + std::to_string(forgetting).substr(0, 4); }

constexpr ClaimSpec kBodeClaims[] = {
    {"6.6.faster", "6.3.3",
     "The convergence speed using a low forgetting factor (top left) is higher compared to using a high forgetting "
     "factor (bottom right).",
     "When the mass is within a twentieth with 0.8, over the same with 0.98.", "1", Relation::kBelow, 1.0},
    {"6.6.variance", "6.3.3",
     "... the variance of the estimates starts to increase more for a low forgetting factor ... than for a high "
     "forgetting factor.",
     "Mean change of the magnitude from tick to tick in the last 50 ms with 0.8, over the same with 0.9.", "1",
     Relation::kAtLeast, 1.0},
    {"6.6.smooth", "6.3.3", "... there is a smooth transition from one estimate to the next ...",
     "The same with 0.98, over that with 0.8: less than a half.", "1", Relation::kBelow, 0.5}};

Result<StudyResult> run_bode(const StudyContext& context) {
  StudyResult result;
  result.measured = {{"6.6.faster", mass_ms(context, 0.8) / mass_ms(context, 0.98), "medians of 15 runs"},
                     {"6.6.variance", spread_dB(context, 0.8) / spread_dB(context, 0.9), "medians of 15 runs"},
                     {"6.6.smooth", spread_dB(context, 0.98) / spread_dB(context, 0.8), "medians of 15 runs"}};
  std::vector<std::vector<Panel>> columns;
  for (const double forgetting : kForgetting) {
    columns.push_back(estimates_of(context, forgetting).bode(title_of(forgetting), 0, kLength));
  }
  result.pictures = {bode_picture("Start 10.5 kg, truth 105 kg (blue): models every 5 ms of 150 ms, black to yellow",
                                  std::move(columns))};
  return result;
}

constexpr const char* kSpeeds =
    "... 0.8 has converged after just 50 ms, whereas for a forgetting factor of 0.9 almost 90 ms are needed.";

constexpr ClaimSpec kMassClaims[] = {
    {"6.7.fast", "6.3.3", kSpeeds, "When the mass stays within a twentieth of the truth with 0.8.", "ms",
     Relation::kAtMost, 50.0},
    {"6.7.slow", "6.3.3", kSpeeds,
     "Distance from 90 ms of the same with 0.9: a fifth of it. The first covariance, which the text does not print, is "
     "chosen for it.",
     "ms", Relation::kAtMost, 18.0},
    {"6.7.very_slow", "6.3.3", "Note the very slow convergence speed in case of a very high forgetting factor 0.98.",
     "The same with 0.98: not within the 150 ms.", "ms", Relation::kAtLeast, 150.0},
    {"6.7.computed", "6.3.3",
     "... the estimates, using this calculated forgetting factor, might not have converged within the required time.",
     "The same with the 0.968 of (6.22), over the quarter of a stance at 4 Hz, 31 ms.", "1", Relation::kAtLeast, 1.0}};

Result<StudyResult> run_mass(const StudyContext& context) {
  const double slow = mass_ms(context, 0.9);
  StudyResult result;
  result.measured = {{"6.7.fast", mass_ms(context, 0.8), "median of 15 runs"},
                     {"6.7.slow", std::abs(slow - 90.0), "median of 15 runs " + std::to_string(slow) + " ms"},
                     {"6.7.very_slow", mass_ms(context, 0.98), "median of 15 runs"},
                     {"6.7.computed", mass_ms(context, 0.968) / 31.25, "median of 15 runs"}};
  Picture picture{"Load mass by forgetting factor", 2, {}};
  for (const double forgetting : kForgetting) {
    picture.panels.push_back(estimates_of(context, forgetting).mass_panel(title_of(forgetting), kLength));
  }
  result.pictures = {std::move(picture)};
  return result;
}

constexpr const char* kConditions =
    "Joint of Table A.1 with 105 kg, perfect sensors, white noise of 5 % at the valve. Least squares (6.21) that "
    "starts from 10.5 "
    "kg. The text does not print the first covariance. It is 0.14 I, which makes 6.7.slow true by choice and no other "
    "claim.";

constexpr Study kStudies[] = {
    {"6.6", "Estimated transfer functions by forgetting factor", kBodeClaims, run_bode, kConditions},
    {"6.7", "Estimated load mass by forgetting factor", kMassClaims, run_mass, kConditions}};

}  // namespace
}  // namespace chapter6_forgetting_studies

std::span<const Study> chapter6_forgetting() { return chapter6_forgetting_studies::kStudies; }

}  // namespace farrier::thesis
