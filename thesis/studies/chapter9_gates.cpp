// Hubacher (2014), Figs 9.4 to 9.7, G.1 and G.2: adaptive forgetting alone and behind gates of excitation, on one chirp.

#include <algorithm>
#include <cmath>

#include "thesis/rig/bode.hpp"
#include "thesis/rig/chirp_figures.hpp"
#include "thesis/rig/rig_conditions.hpp"
#include "thesis/studies/registry.hpp"
#include "thesis/study/mean.hpp"

namespace farrier::thesis {
namespace chapter9_gates_studies {
namespace {

using estimation::GateKind;

// The text names the experiment, d00076, and not its amplitude: the middle one of Fig. 9.1.
constexpr double kAmplitude = 0.1;
constexpr std::size_t kShortest = 50;  // ticks; a gate that opens for less has been brushed, not opened

Result<ChirpEstimates> run_gate(const robot::Robot& rig, const StudyContext& context, GateKind gate) {
  return estimate_chirp(rig, {.amplitude = kAmplitude, .gate = gate}, context.seed);
}

Result<ChirpEstimates> run_gate(const StudyContext& context, GateKind gate) {
  const auto rig = FARRIER_TRY(load_rig(context));
  return run_gate(rig, context, gate);
}

// 9.4

constexpr const char* kImproves = "The PE algorithm does lead to some improvements ...";

constexpr ClaimSpec kMethodClaims[] = {
    {"9.4.misses_beginning", "9.1.2", "Unfortunately, the PE algorithm misses the first region.",
     "Ticks of the first 0.5 s in which the gate was open.", "1", Relation::kAtMost, 0.0},
    {"9.4.pe_improves", "Fig. 9.4", kImproves,
     "Share of estimates, while their gate was open, with a maximum of 3 dB between 0.3 and 10 Hz, over that of "
     "adaptive forgetting alone: below 1.",
     "1", Relation::kBelow, 1.0},
    {"9.4.fft_better", "Fig. 9.4", "... however, the simpler FFT method on the right performs even better.",
     "The same share of the FFT gate less that of the PE gate: at most 0.", "1", Relation::kAtMost, 0.0}};

Result<StudyResult> run_methods(const StudyContext& context) {
  std::vector<ChirpEstimates> runs;
  for (const GateKind gate : {GateKind::kNone, GateKind::kPe, GateKind::kFft}) {
    auto run = FARRIER_TRY(run_gate(context, gate));
    runs.push_back(std::move(run));
  }
  const double alone = open_share(runs[0]);
  const double pe = open_share(runs[1]);
  const double fft = open_share(runs[2]);
  StudyResult result;
  result.measured = {
      {"9.4.misses_beginning", static_cast<double>(std::count(runs[1].open.begin(), runs[1].open.begin() + 500, true)),
       ""},
      {"9.4.pe_improves", pe / alone, number_as("%.3f alone, ", alone) + number_as("%.3f behind the gate", pe)},
      {"9.4.fft_better", fft - pe, number_as("%.3f", fft)}};
  result.pictures = {
      bode_picture("Estimates of a chirp of 10 %, black to yellow; only those taken while the gate was open",
                   {estimates_panels("adaptive forgetting", runs[0]), estimates_panels("and PE gate", runs[1]),
                    estimates_panels("and FFT gate", runs[2])})};
  return result;
}

// 9.5, 9.6

constexpr const char* kSeveralTimes =
    "... the estimation algorithm is switched on and off several times due to the permission given by the PE "
    "condition.";

constexpr const char* kRisesOnce =
    "every lower limit: the least singular value of the chirp of 10 % is 1.4e-3 at most in the first 600 samples and "
    "2e-3 to 5e-3 from 1 s "
    "on, so a limit that the beginning exceeds (9.6.beginning_min) is never undercut later; neither filters of 20 Hz "
    "nor perfect "
    "measurements change that";

constexpr ClaimSpec kPeForgettingClaims[] = {
    fails(kRisesOnce,
          {"9.5.when", "9.1.2",
           "A first activation occurs after 3000 samples lasting for roughly 650 samples. A second activation occurs "
           "... around sample "
           "5100 till 6300.",
           "Of these two openings, those that the gate has within 300 samples: two.", "1", Relation::kAtLeast, 2.0}),
    fails(kRisesOnce, {"9.5.several_times", "9.1.2", kSeveralTimes, "Times the gate opened for 50 ticks or more: two.",
                       "1", Relation::kAtLeast, 2.0}),
    {"9.5.high", "9.1.2",
     "The AFF algorithm keeps the forgetting factors high due to relatively small prediction errors.",
     "Least mean lambda of a row: 0.95.", "1", Relation::kAtLeast, 0.95}};

constexpr ClaimSpec kSingularClaims[] = {
    {"9.6.beginning_min", "9.1.2",
     "... during the first few hundred samples the minimum singular value is larger than the lower limit ...",
     "Largest smallest singular value of the first 600 samples, over the limit.", "1", Relation::kAtLeast, 1.0},
    {"9.6.beginning_max", "9.1.2", "... but the maximum singular value violates the limit.",
     "Largest singular value of the first 600 samples, over the limit.", "1", Relation::kAtLeast, 1.0},
    {"9.6.decisive", "9.1.2",
     "The maximum value then dives under the limit and remains there ... hence only the minimum value is decisive.",
     "Largest singular value from sample 3000 to 6000, over the limit.", "1", Relation::kAtMost, 1.0}};

/// Openings of the text that have one of the run within 300 samples of their beginning and their end.
double openings_of_the_text(const std::vector<Span>& spans) {
  constexpr double kNear = 300.0;
  constexpr std::pair<double, double> kText[] = {{3000.0, 3650.0}, {5100.0, 6300.0}};
  return static_cast<double>(std::ranges::count_if(kText, [&](const auto& text) {
    return std::ranges::any_of(spans, [&](const Span& span) {
      return std::abs(static_cast<double>(span.begin) - text.first) <= kNear &&
             std::abs(static_cast<double>(span.end) - text.second) <= kNear;
    });
  }));
}

Result<StudyResult> run_pe_forgetting(const StudyContext& context) {
  const ChirpEstimates run = FARRIER_TRY(run_gate(context, GateKind::kPe));
  const std::vector<Span> spans = open_spans(run, kShortest);
  double least = 1.0;
  for (int row = 0; row < 3; ++row) {
    least = std::min(least, mean_over(0, run.forgetting.size(), [&](std::size_t i) { return run.forgetting[i](row); }));
  }
  StudyResult result;
  result.measured = {{"9.5.several_times", static_cast<double>(spans.size()), spans_text(spans)},
                     {"9.5.when", openings_of_the_text(spans), ""},
                     {"9.5.high", least, ""}};
  result.pictures = {forgetting_picture("Forgetting factors behind the PE gate; 1 while it is closed", run)};
  return result;
}

Panel open_panel(const ChirpEstimates& run) {
  Series series{"", run.tick_s, {}, Style::kLine, 0};
  for (const bool open : run.open) {
    series.y.push_back(open ? 1.0 : 0.0);
  }
  return {
      .title = "permission to update", .x_label = "time (s)", .y_label = "1 yes, 0 no", .series = {std::move(series)}};
}

Result<StudyResult> run_singular(const StudyContext& context) {
  const auto made = FARRIER_TRY(run_gate(context, GateKind::kPe));
  const ChirpEstimates& run = made;
  const estimation::PersistenceParams limits = *params_of({.amplitude = kAmplitude}).pe;
  const auto largest = [&](int which, std::size_t from, std::size_t to) {
    double found = 0.0;
    for (std::size_t i = from; i < to; ++i) {
      found = std::max(found, run.singular_values[i](which));
    }
    return found;
  };
  StudyResult result;
  result.measured = {{"9.6.beginning_min", largest(0, 0, 600) / limits.information_min, ""},
                     {"9.6.beginning_max", largest(1, 0, 600) / limits.information_max, ""},
                     {"9.6.decisive", largest(1, 3000, 6000) / limits.information_max, ""}};
  Picture picture{"Singular values of the PE condition; dashed: its limits", 1, {}};
  for (const int which : {1, 0}) {
    Series series{"", run.tick_s, {}, Style::kLine, 1};
    for (const Eigen::Vector2d& values : run.singular_values) {
      series.y.push_back(std::max(1e-12, values(which)));
    }
    const double limit = which == 1 ? limits.information_max : limits.information_min;
    picture.panels.push_back({.title = which == 1 ? "largest" : "smallest",
                              .x_label = "time (s)",
                              .y_label = "singular value (1)",
                              .log_y = true,
                              .series = {std::move(series), {"", {0.0, kChirp_s}, {limit, limit}, Style::kDashed, 2}}});
  }
  picture.panels.push_back(open_panel(run));
  result.pictures = {std::move(picture)};
  return result;
}

// 9.7, G.2

constexpr ClaimSpec kFrequencyClaims[] = {
    needs(Condition::kPerfectMeasurements,
          {"9.7.rises", "9.1.2",
           "... the number of significant frequencies rises contiguously with the frequency increase of the chirp "
           "input signal.",
           "Mean number from 6 to 8 s less that from 1 to 3 s.", "1", Relation::kAtLeast, 1.0}),
    {"9.7.burst", "9.1.2",
     "However, at the very beginning of the experiment, a high number of excited frequencies occurs.",
     "Largest number of the windows that end in the first 0.6 s less the mean from 1 to 3 s.", "1", Relation::kAtLeast,
     1.0},
    {"9.7.not_in_the_middle", "9.1.2",
     "... the FFT algorithm does not show any increase in excitation in the middle of the experiment.",
     "Times the gate opened for 50 ticks or more after 1 s.", "1", Relation::kAtMost, 1.0}};

Result<StudyResult> frequencies_on(const robot::Robot& rig, const StudyContext& context) {
  const ChirpEstimates run = FARRIER_TRY(run_gate(rig, context, GateKind::kFft));
  const auto count = [&](std::size_t i) { return static_cast<double>(run.frequencies[i]); };
  const double quiet = mean_over(1000, 3000, count);
  const double late = mean_over(6000, run.frequencies.size(), count);
  const estimation::SpectrumParams gate = *params_of({.amplitude = kAmplitude}).fft;
  const int window = gate.window_ticks;
  const int burst = *std::max_element(run.frequencies.begin() + window, run.frequencies.begin() + 600);
  std::vector<Span> spans = open_spans(run, kShortest);
  const std::string note = spans_text(spans);
  std::erase_if(spans, [](const Span& span) { return span.begin < 1000; });
  StudyResult result;
  result.measured = {{"9.7.rises", late - quiet, number_as("%.1f, ", late) + number_as("%.1f", quiet)},
                     {"9.7.burst", burst - quiet, ""},
                     {"9.7.not_in_the_middle", static_cast<double>(spans.size()), note}};
  Series series{"frequencies", {run.tick_s.begin() + window, run.tick_s.end()}, {}, Style::kLine, 1};
  series.y.assign(run.frequencies.begin() + window, run.frequencies.end());
  const double limit = gate.frequencies_min;
  result.pictures = {
      {"Frequencies of the signals above the threshold",
       1,
       {{.title = "",
         .x_label = "time (s)",
         .y_label = "count",
         .series = {std::move(series), {"more are needed", {0.0, kChirp_s}, {limit, limit}, Style::kDashed, 2}}},
        open_panel(run)}}};
  return result;
}

Result<StudyResult> run_frequencies(const StudyContext& context) {
  const auto loaded = FARRIER_TRY(load_rig(context));
  return measure_on(loaded, kFrequencyClaims, [&](const robot::Robot& rig) { return frequencies_on(rig, context); });
}

constexpr ClaimSpec kAloneClaims[] = {
    {"G.1.high", "Fig. G.1",
     "Plot of the individual forgetting factors lambda_i calculated by the adaptive forgetting factor (AFF) algorithm "
     "...",
     "Least mean lambda of a row from 1 s on, as 9.1.1 has it for Fig. 9.3 (\"They remain largely at 1\"): 0.95.", "1",
     Relation::kAtLeast, 0.95}};
constexpr ClaimSpec kFftForgettingClaims[] = {
    needs(Condition::kPerfectMeasurements,
          {"G.2.gated", "9.1.2",
           "... this burst of excitation is not long enough or the algorithm does not take full advantage of it ...",
           "Ticks of the first 1 s in which the gate was open, over those from 5 s on.", "1", Relation::kAtMost, 0.5}),
    {"G.2.inaccurate", "9.1.2",
     "... the prediction error is drastically reduced, however not enough, yielding inaccurate estimates.",
     "RMS distance in dB from the nominal response, 1 to 100 Hz, mean from 2 to 3 s: 2 dB or more.", "dB",
     Relation::kAtLeast, 2.0}};

Result<StudyResult> run_alone(const StudyContext& context) {
  const auto made = FARRIER_TRY(run_gate(context, GateKind::kNone));
  const ChirpEstimates& run = made;
  double least = 1.0;
  for (int row = 0; row < 3; ++row) {
    least =
        std::min(least, mean_over(1000, run.forgetting.size(), [&](std::size_t i) { return run.forgetting[i](row); }));
  }
  StudyResult result;
  result.measured = {{"G.1.high", least, ""}};
  result.pictures = {forgetting_picture("Forgetting factors, chirp of 10 %", run)};
  return result;
}

Result<StudyResult> fft_forgetting_on(const robot::Robot& rig, const StudyContext& context) {
  const ChirpEstimates run = FARRIER_TRY(run_gate(rig, context, GateKind::kFft));
  const double first = static_cast<double>(std::count(run.open.begin(), run.open.begin() + 1000, true));
  const double last = static_cast<double>(std::count(run.open.begin() + 5000, run.open.end(), true));
  StudyResult result;
  result.measured = {{"G.2.gated", first / last, number_as("%.0f ticks, ", first) + number_as("%.0f", last)},
                     {"G.2.inaccurate", distance_dB(run, 2.0, 3.0), ""}};
  result.pictures = {forgetting_picture("Forgetting factors behind the FFT gate; 1 while it is closed", run)};
  return result;
}

Result<StudyResult> run_fft_forgetting(const StudyContext& context) {
  const auto loaded = FARRIER_TRY(load_rig(context));
  return measure_on(loaded, kFftForgettingClaims,
                    [&](const robot::Robot& rig) { return fft_forgetting_on(rig, context); });
}

constexpr Study kStudies[] = {
    {"9.4", "Estimates behind gates of excitation", kMethodClaims, run_methods, kOnTheRigEstimated},
    {"9.5", "Forgetting factors behind the PE gate", kPeForgettingClaims, run_pe_forgetting, kOnTheRigEstimated},
    {"9.6", "Singular values of the PE gate", kSingularClaims, run_singular, kOnTheRigEstimated},
    {"9.7", "Frequencies of the FFT gate", kFrequencyClaims, run_frequencies, kOnTheRigEstimated},
    {"G.1", "Forgetting factors without a gate", kAloneClaims, run_alone, kOnTheRigEstimated},
    {"G.2", "Forgetting factors behind the FFT gate", kFftForgettingClaims, run_fft_forgetting, kOnTheRigEstimated}};

}  // namespace
}  // namespace chapter9_gates_studies

std::span<const Study> chapter9_gates() { return chapter9_gates_studies::kStudies; }

}  // namespace farrier::thesis
