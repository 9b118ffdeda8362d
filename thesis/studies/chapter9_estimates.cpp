// Hubacher (2014), Figs 9.1 to 9.3: the estimator on chirps of the valve current, with a constant and with an adaptive
// forgetting factor.

#include <algorithm>
#include <cmath>

#include "thesis/rig/bode.hpp"
#include "thesis/rig/chirp_figures.hpp"
#include "thesis/rig/rig_conditions.hpp"
#include "thesis/studies/registry.hpp"
#include "thesis/study/mean.hpp"

namespace farrier::thesis {
namespace chapter9_estimates_studies {
namespace {

using estimation::EstimationMethod;

constexpr double kAmplitudes[] = {0.05, 0.1, 0.2};
constexpr double kEarly_s = 2.0;  // up to 7.5 Hz
constexpr double kLate_s = 4.0;   // from 15 Hz on

/// A run for each amplitude.
Result<std::vector<ChirpEstimates>> run_amplitudes(const StudyContext& context, const robot::Robot& rig,
                                                   EstimationMethod method, double from, double to) {
  std::vector<ChirpEstimates> runs;
  for (const double amplitude : kAmplitudes) {
    auto run = FARRIER_TRY(estimate_chirp(rig, {.amplitude = amplitude, .method = method}, context.seed));
    runs.push_back(std::move(run));
    if (!keep_going(context, from + (to - from) * static_cast<double>(runs.size()) / std::size(kAmplitudes))) {
      return stopped();
    }
  }
  return runs;
}

Picture picture_of(const std::string& caption, const std::vector<ChirpEstimates>& runs) {
  std::vector<std::vector<Panel>> columns;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    columns.push_back(estimates_panels(number_as("%g %% of the opening", 100.0 * kAmplitudes[i]), runs[i]));
  }
  return bode_picture(caption, std::move(columns));
}

double mean_share(const std::vector<ChirpEstimates>& runs, double from_s, double to_s) {
  return mean_over(0, runs.size(), [&](std::size_t i) { return fictive_share(runs[i], from_s, to_s); });
}

std::string shares_text(const std::vector<ChirpEstimates>& runs, double from_s, double to_s) {
  std::string text = "by amplitude:";
  for (const ChirpEstimates& run : runs) {
    text += number_as(" %.2f", fictive_share(run, from_s, to_s));
  }
  return text;
}

constexpr const char* kDisappear =
    "As soon as the chirp signal excites the system enough, these resonance peaks disappear ...";
constexpr const char* kAmplitude =
    "... the amplitude of the chirp input directly affects the degree of excitation. The performance of the estimator "
    "increases with better excited systems.";

constexpr const char* kPeaks =
    "... the system is not fully excited, hence the estimated transfer functions contain fictive resonance peaks at "
    "low frequencies.";
constexpr ClaimSpec kConstantClaims[] = {
    fails(
        "0.07 to 0.11 over the seeds, 0.09 to 0.14 with 20 Hz on the force as well, 0.04 without dry friction, 0.05 "
        "with perfect measurements",
        {"9.1.peaks", "9.1", kPeaks,
         "Share of the first 2 s of estimates with a maximum of 3 dB between 0.3 and 10 Hz, mean of the amplitudes: a "
         "tenth or more.",
         "1", Relation::kAtLeast, 0.1}),
    {"9.1.disappear", "9.1", kDisappear, "The share from 4 s on over that of the first 2 s: a half.", "1",
     Relation::kAtMost, 0.5},
    {"9.1.later", "9.1", kDisappear, "The share from 4 s on: a tenth.", "1", Relation::kAtMost, 0.1},
    needs(Condition::kPerfectMeasurements, {"9.1.amplitude", "9.1", kAmplitude,
                                            "RMS distance from the nominal response, 1 to 100 Hz, last second, at 5 % "
                                            "less that at 20 %: a decibel or more.",
                                            "dB", Relation::kAtLeast, 1.0}),
    {"9.1.rough", "9.1",
     "Even towards the end of the chirp signal, the estimator is only able to give a rough approximation ...",
     "The distance at 20 %: 2 dB or more.", "dB", Relation::kAtLeast, 2.0},
    {"9.1.approximation", "9.1",
     "... the linear estimator is able to partially identify the essential dynamics of the hydraulic system ...",
     "The distance at 20 %, over that of the first guess: a half.", "1", Relation::kAtMost, 0.5}};

Result<StudyResult> run_constant(const StudyContext& context) {
  const auto loaded = FARRIER_TRY(load_rig(context));
  return measure_on(loaded, kConstantClaims, [&](const robot::Robot& rig) -> Result<StudyResult> {
    const auto runs = FARRIER_TRY(run_amplitudes(context, rig, EstimationMethod::kRls, 0.0, 1.0));
    const double early = mean_share(runs, 0.0, kEarly_s);
    const double later = mean_share(runs, kLate_s, kChirp_s);
    const double weak = distance_dB(runs.front(), kChirp_s - 1.0, kChirp_s);
    const double strong = distance_dB(runs.back(), kChirp_s - 1.0, kChirp_s);
    StudyResult result;
    result.measured = {{"9.1.peaks", early, shares_text(runs, 0.0, kEarly_s)},
                       {"9.1.disappear", later / early, ""},
                       {"9.1.later", later, shares_text(runs, kLate_s, kChirp_s)},
                       {"9.1.amplitude", weak - strong, number_as("%.1f dB, ", weak) + number_as("%.1f dB", strong)},
                       {"9.1.rough", strong, ""},
                       {"9.1.approximation", strong / first_distance_dB(runs.back()), ""}};
    result.pictures = {picture_of("Estimates with a forgetting factor of 0.92, black to yellow over the chirp", runs)};
    return result;
  });
}

constexpr ClaimSpec kAdaptiveClaims[] = {
    {"9.2.peaks", "9.1.1", "... less inappropriate resonance peaks appear at low frequencies.",
     "Share of all estimates with a maximum of 3 dB between 0.3 and 10 Hz, mean of the amplitudes, over that of Fig. "
     "9.1: below 1.",
     "1", Relation::kBelow, 1.0},
    {"9.2.smooth", "9.1.1",
     "The gradient of estimates is much smoother from one time step to the next and consequently slower.",
     "Mean RMS change of the response in 20 ms, from 0.5 s on, over that of Fig. 9.1: a half.", "1", Relation::kAtMost,
     0.5},
    needs(Condition::kPerfectMeasurements,
          {"9.2.amplitude", "9.1.1",
           "The estimator is able to identify more high frequency parts of the system because the magnitude of the "
           "input is larger ...",
           "RMS distance from the nominal response, 30 to 150 Hz, last second, at 5 % less that at 20 %: above 0.",
           "dB", Relation::kAtLeast, 0.0})};

Result<StudyResult> adapt_on(const robot::Robot& rig, const StudyContext& context) {
  const auto adaptive = run_amplitudes(context, rig, EstimationMethod::kAff, 0.0, 0.5);
  const auto constant = adaptive ? run_amplitudes(context, rig, EstimationMethod::kRls, 0.5, 1.0) : adaptive;
  if (!constant) {
    return constant.error();
  }
  const std::vector<ChirpEstimates>& runs = adaptive.value();
  const auto roughness = [](const std::vector<ChirpEstimates>& some) {
    double sum = 0.0;
    for (const ChirpEstimates& run : some) {
      sum += roughness_dB(run, 0.5, kChirp_s);
    }
    return sum;
  };
  const auto high = [](const ChirpEstimates& run) { return distance_dB(run, kChirp_s - 1.0, kChirp_s, 30.0, 150.0); };
  StudyResult result;
  result.measured = {{"9.2.peaks", mean_share(runs, 0.0, kChirp_s) / mean_share(constant.value(), 0.0, kChirp_s),
                      shares_text(runs, 0.0, kChirp_s)},
                     {"9.2.smooth", roughness(runs) / roughness(constant.value()), ""},
                     {"9.2.amplitude", high(runs.front()) - high(runs.back()),
                      number_as("%.1f dB, ", high(runs.front())) + number_as("%.1f dB", high(runs.back()))}};
  result.pictures = {picture_of("Estimates with adaptive forgetting, black to yellow over the chirp", runs)};
  return result;
}

Result<StudyResult> run_adaptive(const StudyContext& context) {
  const auto loaded = FARRIER_TRY(load_rig(context));
  return measure_on(loaded, kAdaptiveClaims, [&](const robot::Robot& rig) { return adapt_on(rig, context); });
}

/// Mean of a row's lambda between two times.
double mean_lambda(const ChirpEstimates& run, int row, double from_s, double to_s) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < run.tick_s.size(); ++i) {
    if (run.tick_s[i] >= from_s && run.tick_s[i] < to_s) {
      sum += run.forgetting[i](row);
      count += 1.0;
    }
  }
  return sum / count;
}

double least_lambda(const ChirpEstimates& run, int row, double from_s) {
  double least = 1.0;
  for (std::size_t i = 0; i < run.tick_s.size(); ++i) {
    if (run.tick_s[i] >= from_s) {
      least = std::min(least, run.forgetting[i](row));
    }
  }
  return least;
}

constexpr const char* kLargely = "They remain largely at 1 (meaning less forgetting) ...";
constexpr const char* kByNoise = "... but the velocity related forgetting factor is influenced slightly by the noise.";

constexpr const char* kForceAlone =
    "c_1 of 0.25 to 256: sigma_v is that of raw readings and the velocity passes 20 Hz, so its errors stay below; the "
    "force, whose cell is "
    "the better sensor and whose filter the faster, is the one that forgets. With perfect measurements all three "
    "forget alike";

constexpr ClaimSpec kForgettingClaims[] = {
    {"9.3.largely", "9.1.1", kLargely, "Smallest mean lambda of a row from 1 s on: 0.95.", "1", Relation::kAtLeast,
     0.95},
    fails(kForceAlone, {"9.3.velocity", "9.1.1", kByNoise,
                        "Mean lambda of the velocity less the smaller of the other two, from 1 s on: at most 0.", "1",
                        Relation::kAtMost, 0.0}),
    fails(kForceAlone, {"9.3.dips", "9.1.1", kByNoise, "Least lambda of the velocity from 1 s on: 0.99.", "1",
                        Relation::kAtMost, 0.99}),
    {"9.3.promptly", "9.1.1",
     "The prediction error of the estimator decreases promptly ... in accordance to a steep increase of all three "
     "forgetting factors.",
     "Least of the mean lambdas of the rows from 0.1 to 0.3 s: 0.9.", "1", Relation::kAtLeast, 0.9}};

Result<StudyResult> run_forgetting(const StudyContext& context) {
  const auto rig = FARRIER_TRY(load_rig(context));
  const auto made = FARRIER_TRY(estimate_chirp(rig, {.amplitude = 0.2}, context.seed));
  const ChirpEstimates& run = made;
  double later[3];
  double soon[3];
  for (int row = 0; row < 3; ++row) {
    later[row] = mean_lambda(run, row, 1.0, kChirp_s);
    soon[row] = mean_lambda(run, row, 0.1, 0.3);
  }
  StudyResult result;
  result.measured = {{"9.3.largely", std::min({later[0], later[1], later[2]}),
                      number_as("position %.4f, ", later[0]) + number_as("velocity %.4f, ", later[1]) +
                          number_as("force %.4f", later[2])},
                     {"9.3.velocity", later[1] - std::min(later[0], later[2]), ""},
                     {"9.3.dips", least_lambda(run, 1, 1.0), ""},
                     {"9.3.promptly", std::min({soon[0], soon[1], soon[2]}), ""}};
  result.pictures = {forgetting_picture("Forgetting factors, chirp of 20 %", run)};
  return result;
}

constexpr Study kStudies[] = {
    {"9.1", "Estimates on the rig, constant forgetting", kConstantClaims, run_constant, kOnTheRigEstimated},
    {"9.2", "Estimates on the rig, adaptive forgetting", kAdaptiveClaims, run_adaptive, kOnTheRigEstimated},
    {"9.3", "Forgetting factors on the rig", kForgettingClaims, run_forgetting, kOnTheRigEstimated}};

}  // namespace
}  // namespace chapter9_estimates_studies

std::span<const Study> chapter9_estimates() { return chapter9_estimates_studies::kStudies; }

}  // namespace farrier::thesis
