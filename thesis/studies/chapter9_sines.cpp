// Hubacher (2014), Figs 9.11, 9.12, 9.14, G.7 and G.8: the LQR for 2.5 kg under sines of force on the rig with 2.5 kg.

#include <algorithm>
#include <cmath>

#include "thesis/rig/rig_conditions.hpp"
#include "thesis/rig/rig_run.hpp"
#include "thesis/studies/registry.hpp"

namespace farrier::thesis {
namespace chapter9_sines_studies {
namespace {

using control::Form;

constexpr double kSettled_s = 1.0, kRun_s = 5.0;
struct Sine {
  double amplitude_N, frequency_Hz;
};

Result<std::vector<RigTrace>> run_sines(const StudyContext& context, const robot::Robot& rig,
                                        std::span<const Sine> sines, Form form) {
  std::vector<RigTrace> runs;
  for (std::size_t i = 0; i < sines.size(); ++i) {
    auto run = FARRIER_TRY(track(rig,
                                 {.reference = sine(sines[i].amplitude_N, sines[i].frequency_Hz),
                                  .duration_s = kRun_s,
                                  .form = form,
                                  .feed_forward_factor = form == Form::kFullState ? 1.0 : kSmallFeedForward},
                                 context.seed));
    if (!keep_going(context, static_cast<double>(i + 1) / static_cast<double>(sines.size()))) {
      return stopped();
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

std::vector<double> errors_of(const std::vector<RigTrace>& runs) {
  std::vector<double> errors;
  for (const RigTrace& run : runs) {
    errors.push_back(tracking_error(run, kSettled_s, kRun_s));
  }
  return errors;
}

std::string errors_text(const std::vector<double>& errors) {
  std::string text = "errors:";
  for (const double error : errors) {
    text += number_as(" %.3f", error);
  }
  return text;
}

Picture force_picture(const std::string& caption, std::span<const Sine> sines, const std::vector<RigTrace>& runs) {
  Picture picture{caption, 1, {}};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    picture.panels.push_back(
        force_panel(number_as("%g N, ", sines[i].amplitude_N) + number_as("%g Hz", sines[i].frequency_Hz), runs[i]));
  }
  return picture;
}

constexpr Sine kFrequencies[] = {{120.0, 1.0}, {120.0, 1.5}, {120.0, 2.0}, {120.0, 2.5}, {120.0, 3.5}};

constexpr const char* kRatherGood =
    "As can be seen, the force tracking is rather good, regardless of reference signal frequency.";

constexpr ClaimSpec kFrequencyClaims[] = {
    {"9.11.error", "Fig. 9.11", kRatherGood, "Largest of the five RMS errors over RMS reference: a quarter.", "1",
     Relation::kAtMost, 0.25},
    fails("the errors are 0.03 to 0.14: small at each frequency (9.11.error), and growing with it, as a fixed linear "
          "controller's do. Perfect measurements make the small ones smaller (7.7)",
          {"9.11.regardless", "Fig. 9.11", kRatherGood, "Largest of the five over the smallest: three.", "1",
           Relation::kAtMost, 3.0}),
    {"9.11.highest", "9.2.1",
     "... the force tracking performance is quite good, even for signals with a higher frequency of 3.5 Hz.",
     "RMS error over RMS reference at 3.5 Hz: a quarter.", "1", Relation::kAtMost, 0.25}};

Result<StudyResult> run_frequencies(const StudyContext& context) {
  const auto loaded = FARRIER_TRY(load_rig(context));
  return measure_on(loaded, kFrequencyClaims, [&](const robot::Robot& rig) -> Result<StudyResult> {
    const auto runs = FARRIER_TRY(run_sines(context, rig, kFrequencies, Form::kFullState));
    const std::vector<double> errors = errors_of(runs);
    StudyResult result;
    result.measured = {{"9.11.error", std::ranges::max(errors), errors_text(errors)},
                       {"9.11.regardless", std::ranges::max(errors) / std::ranges::min(errors), ""},
                       {"9.11.highest", errors.back(), ""}};
    result.pictures = {force_picture("Full-state LQR, sines of 120 N", kFrequencies, runs)};
    return result;
  });
}

constexpr Sine kAmplitudes[] = {{60.0, 0.5}, {160.0, 1.0}, {260.0, 1.0}};

constexpr ClaimSpec kAmplitudeClaims[] = {
    {"9.12.error", "Fig. 9.12",
     "The force tracking, as can be seen, is quite good, regardless of reference signal amplitude.",
     "Largest of the three RMS errors over RMS reference: a quarter.", "1", Relation::kAtMost, 0.25}};

Result<StudyResult> run_amplitudes(const StudyContext& context) {
  const auto loaded = FARRIER_TRY(load_rig(context));
  return measure_on(loaded, kAmplitudeClaims, [&](const robot::Robot& rig) -> Result<StudyResult> {
    const auto runs = FARRIER_TRY(run_sines(context, rig, kAmplitudes, Form::kFullState));
    const std::vector<double> errors = errors_of(runs);
    StudyResult result;
    result.measured = {{"9.12.error", std::ranges::max(errors), errors_text(errors)}};
    result.pictures = {force_picture("Full-state LQR, sines of three amplitudes", kAmplitudes, runs)};
    return result;
  });
}

/// Cosine between two signals from kSettled_s on: -1 where the one undoes the other.
double agreement(const RigTrace& run, const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (run.time_s[i] >= kSettled_s) {
      sum += a[i] * b[i];
      count += 1.0;
    }
  }
  return sum / count / (rms(run, a, kSettled_s, kRun_s) * rms(run, b, kSettled_s, kRun_s));
}

std::vector<double> sum_of(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> sum(a.size());
  std::ranges::transform(a, b, sum.begin(), std::plus<>());
  return sum;
}

constexpr const char* kFights =
    "Note how the position channel of the full LQR controller fights the velocity and force channels.";

constexpr ClaimSpec kFormClaims[] = {
    {"9.14.fights", "Fig. 9.14", kFights,
     "Cosine between the position part and the sum of velocity and force part, full-state form: below -0.5.", "1",
     Relation::kBelow, -0.5,
     Refutation{"position and velocity of a sine are in quadrature whatever the gains (9.14.quadrature), and the force "
                "part is small beside "
                "the velocity part: what the position part fights is the rest (9.14.fights_rest)",
                -0.2, 0.2}},
    proof({"9.14.quadrature", "Fig. 9.14", kFights,
           "Size of the cosine between position and velocity part, as the proof of 9.14.fights asks for: a tenth.", "1",
           Relation::kAtMost, 0.1}),
    proof({"9.14.fights_rest", "9.2.4",
           "... the position channel was acting against the force and velocity channel, hence the feedforward term was "
           "needed ...",
           "Cosine between the position part and the sum of force part and integral, full-state form without "
           "feed-forward: below -0.5.",
           "1", Relation::kBelow, -0.5}),
    {"9.14.feed_forward", "Fig. 9.14", "A force feedforward term is needed to compensate for the position influence.",
     "Cosine between the position part and the feed-forward, full-state form: below -0.5.", "1", Relation::kBelow,
     -0.5},
    {"9.14.full_error", "9.2.4", "... the force tracking of the \"non-compliant\" LQR controller (left) is quite good.",
     "RMS error over RMS reference, full-state form: a quarter.", "1", Relation::kAtMost, 0.25},
    {"9.14.compliant_error", "9.2.4",
     "... little loss in tracking performance when eliminating the position channel ...",
     "RMS error over RMS reference of the compliant form, without feed-forward, less the full-state form's: a tenth.",
     "1", Relation::kAtMost, 0.1},
    fails("without dry friction 0.0, with the valve of the data sheet 0.2, with perfect measurements 0.2 degrees: the "
          "integrator of xi = 6 "
          "leaves no more",
          {"9.14.compliant_lag", "Fig. 9.14", "However, a slight phase delay is visible.",
           "Lag of the compliant form less that of the full-state form: a degree or more.", "deg", Relation::kAtLeast,
           1.0}),
    {"9.14.compliant_lag_is_slight", "9.2.4",
     "There is some small phase delay in the force tracking when using the \"compliant\" LQR controller (right).",
     "Lag of the compliant form: 15 degrees.", "deg", Relation::kAtMost, 15.0}};

Result<StudyResult> run_forms(const StudyContext& context) {
  const auto rig = FARRIER_TRY(load_rig(context));
  const auto full = track(
      rig, {.reference = sine(300.0, 1.0), .duration_s = kRun_s, .form = Form::kFullState, .feed_forward_factor = 1.0},
      context.seed);
  const auto without = full ? track(rig,
                                    {.reference = sine(300.0, 1.0),
                                     .duration_s = kRun_s,
                                     .form = Form::kFullState,
                                     .feed_forward_factor = 0.0},
                                    context.seed)
                            : full;
  const auto compliant = without ? track(rig,
                                         {.reference = sine(200.0, 1.0),
                                          .duration_s = kRun_s,
                                          .form = Form::kCompliant,
                                          .feed_forward_factor = 0.0},
                                         context.seed)
                                 : without;
  if (!compliant) {
    return compliant.error();
  }
  const RigTrace &f = full.value(), &c = compliant.value(), &w = without.value();
  const double full_error = tracking_error(f, kSettled_s, kRun_s);
  const double compliant_error = tracking_error(c, kSettled_s, kRun_s);
  const double lag = lag_deg(c, 1.0, kSettled_s);
  StudyResult result;
  result.measured = {
      {"9.14.fights", agreement(f, f.position_part_A, sum_of(f.velocity_part_A, f.force_part_A)), ""},
      {"9.14.quadrature", std::abs(agreement(f, f.position_part_A, f.velocity_part_A)), ""},
      {"9.14.fights_rest", agreement(w, w.position_part_A, sum_of(w.force_part_A, w.integral_part_A)), ""},
      {"9.14.feed_forward", agreement(f, f.position_part_A, f.feed_forward_part_A), ""},
      {"9.14.full_error", full_error, ""},
      {"9.14.compliant_error", compliant_error - full_error, number_as("compliant %.3f", compliant_error)},
      {"9.14.compliant_lag", lag - lag_deg(f, 1.0, kSettled_s), ""},
      {"9.14.compliant_lag_is_slight", lag, ""}};
  const double nominal_A = rig.joints[0].normalisation.current_A;
  result.pictures = {{"Sine of 1 Hz, 300 N and 200 N, and what the output is made of",
                      2,
                      {force_panel("full state", f), force_panel("compliant, no feed-forward", c),
                       parts_panel(f, nominal_A), parts_panel(c, nominal_A)}}};
  return result;
}

constexpr Sine kWeak[] = {{200.0, 1.0}, {200.0, 2.0}, {200.0, 3.0}, {200.0, 5.0}};
constexpr Sine kStrong[] = {{400.0, 1.0}, {400.0, 2.0}, {400.0, 3.0}, {400.0, 5.0}};

/// Ripple of the velocity part quicker than a twentieth of the period, over the part's own RMS: what sticking leaves.
double sticking(const RigTrace& run, double frequency_Hz) {
  return ripple(run, run.velocity_part_A, 0.05 / frequency_Hz, kSettled_s, kRun_s) /
         rms(run, run.velocity_part_A, kSettled_s, kRun_s);
}

Result<StudyResult> run_compliant(const robot::Robot& rig, const StudyContext& context, std::span<const Sine> sines,
                                  std::string_view figure) {
  const auto made = run_sines(context, rig, sines, Form::kCompliant);
  if (!made) {
    return made.error();
  }
  const std::vector<RigTrace>& runs = made.value();
  const std::vector<double> errors = errors_of(runs);
  std::vector<double> lags, sticks;
  Picture picture{"Compliant LQR: force, and what the output is made of", 2, {}};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    lags.push_back(lag_deg(runs[i], sines[i].frequency_Hz, kSettled_s));
    sticks.push_back(sticking(runs[i], sines[i].frequency_Hz));
    picture.panels.push_back(
        force_panel(number_as("%g N, ", sines[i].amplitude_N) + number_as("%g Hz", sines[i].frequency_Hz), runs[i]));
    picture.panels.push_back(parts_panel(runs[i], rig.joints[0].normalisation.current_A));
  }
  const auto id = [&](const char* name) { return std::string(figure) + "." + name; };
  StudyResult result;
  result.measured = {{id("error"), *std::max_element(errors.begin(), errors.end() - 1), ""},
                     {id("lag"), lags.back(), ""},
                     {id("lag_grows"), lags.back() - lags.front(), ""},
                     {id("sticks"), sticks.front() / sticks.back(),
                      number_as("at 1 Hz %.3f", sticks.front()) + number_as(", at 5 Hz %.3f", sticks.back())}};
  result.pictures = {std::move(picture)};
  return result;
}

constexpr const char* kSticks =
    "Note also how the stick friction influence is particularly visible for the 1 Hz sine wave ...";

constexpr ClaimSpec kWeakClaims[] = {
    {"G.7.error", "Fig. G.7", "The force tracking, as can be seen, is quite good, for sine waves below 5 Hz.",
     "Largest RMS error over RMS reference at 1, 2 and 3 Hz: a quarter.", "1", Relation::kAtMost, 0.25},
    {"G.7.lag", "Fig. G.7", "A phase delay is present for frequencies higher than 5 Hz.",
     "Lag at 5 Hz: 5 degrees or more.", "deg", Relation::kAtLeast, 5.0},
    {"G.7.lag_grows", "Fig. G.7", "A phase delay is present for frequencies higher than 5 Hz.",
     "Lag at 5 Hz less that at 1 Hz: a degree or more.", "deg", Relation::kAtLeast, 1.0},
    {"G.7.sticks", "Fig. G.7", kSticks,
     "Quick ripple of the velocity part over its RMS, at 1 Hz over that at 5 Hz: 1.5 or more.", "1", Relation::kAtLeast,
     1.5}};

constexpr ClaimSpec kStrongClaims[] = {
    needs(Condition::kDataSheetValve,
          {"G.8.error", "G.2.1", "Similar sine waves but with increased amplitude 400 N were commanded ...",
           "Largest RMS error over RMS reference at 1, 2 and 3 Hz: a quarter.", "1", Relation::kAtMost, 0.25}),
    {"G.8.lag", "Fig. G.8", "Again, a phase delay is present for frequencies higher than 3 Hz.",
     "Lag at 5 Hz: 5 degrees or more.", "deg", Relation::kAtLeast, 5.0},
    {"G.8.lag_grows", "Fig. G.8", "Again, a phase delay is present for frequencies higher than 3 Hz.",
     "Lag at 5 Hz less that at 1 Hz: a degree or more.", "deg", Relation::kAtLeast, 1.0},
    {"G.8.sticks", "Fig. G.8", "... the stick friction influence is particularly visible for the 1 Hz sine wave ...",
     "Quick ripple of the velocity part over its RMS, at 1 Hz over that at 5 Hz: 1.5 or more.", "1", Relation::kAtLeast,
     1.5}};

Result<StudyResult> run_weak(const StudyContext& context) {
  const auto rig = FARRIER_TRY(load_rig(context));
  return run_compliant(rig, context, kWeak, "G.7");
}

Result<StudyResult> run_strong(const StudyContext& context) {
  const auto rig = FARRIER_TRY(load_rig(context));
  return measure_on(rig, kStrongClaims,
                    [&](const robot::Robot& robot) { return run_compliant(robot, context, kStrong, "G.8"); });
}

constexpr Study kStudies[] = {
    {"9.11", "LQR on the rig: sines of 1 to 3.5 Hz", kFrequencyClaims, run_frequencies, kOnTheRigFullState},
    {"9.12", "LQR on the rig: sines of 60 to 260 N", kAmplitudeClaims, run_amplitudes, kOnTheRigFullState},
    {"9.14", "Compliant against full-state LQR: sine", kFormClaims, run_forms, kOnTheRigCompliant},
    {"G.7", "Compliant LQR: sines of 200 N", kWeakClaims, run_weak, kOnTheRigCompliant},
    {"G.8", "Compliant LQR: sines of 400 N", kStrongClaims, run_strong, kOnTheRigCompliant}};

}  // namespace
}  // namespace chapter9_sines_studies

std::span<const Study> chapter9_sines() { return chapter9_sines_studies::kStudies; }

}  // namespace farrier::thesis
