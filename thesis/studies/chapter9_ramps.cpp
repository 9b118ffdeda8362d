// Hubacher (2014), Figs G.9 and G.10: ramps and steps of force under added weight, gains for 2.5 kg.

#include <algorithm>
#include <cmath>

#include "thesis/studies/registry.hpp"
#include "thesis/rig/rig_conditions.hpp"
#include "thesis/rig/rig_run.hpp"

namespace farrier::thesis {
namespace chapter9_ramps_studies {
namespace {

std::string pair_text(double without, double with_20) {
  return number_as("%.3f, with ", without) + number_as("20 kg %.3f", with_20);
}

constexpr double kBegin_s = 0.5;
constexpr double kRamp_s = 0.5;
constexpr double kReferenceRun_s = 2.0;
constexpr const char* kDeteriorates =
    "It can again be observed that the force tracking deteriorates for increased weight (+20 kg) when the controller "
    "gains remain fixed.";

constexpr ClaimSpec kRampClaims[] = {
    {"G.9.200", "9.2.6", kDeteriorates,
     "RMS error of the ramp to 200 N with 20 kg added over that without: 1.1 or more.", "1", Relation::kAtLeast, 1.1},
    {"G.9.400", "9.2.6", kDeteriorates, "The same, 400 N.", "1", Relation::kAtLeast, 1.1}};
constexpr ClaimSpec kStepClaims[] = {
    {"G.10.200", "9.2.6", kDeteriorates,
     "Overshoot of the step to 200 N with 20 kg added over that without: 1.1 or more.", "1", Relation::kAtLeast, 1.1},
    {"G.10.400", "9.2.6", kDeteriorates, "The same, 400 N.", "1", Relation::kAtLeast, 1.1}};

Result<StudyResult> run_references(const StudyContext& context, double rise_s, const char* figure) {
  const auto rig = FARRIER_TRY(load_rig(context));
  StudyResult result;
  Picture picture{"Compliant LQR for 2.5 kg, without and with 20 kg added", 2, {}};
  for (const double to_N : {200.0, 400.0}) {
    const Signal reference = [=](double t) {
      return rise_s > 0.0 ? to_N * std::clamp((t - kBegin_s) / rise_s, 0.0, 1.0) : (t < kBegin_s ? 0.0 : to_N);
    };
    std::vector<double> errors, peaks;
    for (const double added_kg : {0.0, 20.0}) {
      const RigTrace run = FARRIER_TRY(track(
          rig, {.reference = reference, .duration_s = kReferenceRun_s, .added = {{0.0, added_kg}}}, context.seed));
      errors.push_back(tracking_error(run, kBegin_s, kReferenceRun_s));
      peaks.push_back(std::ranges::max(run.force_N) / to_N - 1.0);
      picture.panels.push_back(force_panel(number_as("%g N, ", to_N) + number_as("+%g kg", added_kg), run));
    }
    const std::string id = figure + number_as(".%g", to_N);
    const std::string note =
        "RMS error " + pair_text(errors[0], errors[1]) + "; overshoot " + pair_text(peaks[0], peaks[1]);
    result.measured.push_back({id, rise_s > 0.0 ? errors[1] / errors[0] : peaks[1] / peaks[0], note});
  }
  result.pictures = {std::move(picture)};
  return result;
}

Result<StudyResult> run_ramps(const StudyContext& context) { return run_references(context, kRamp_s, "G.9"); }
Result<StudyResult> run_steps(const StudyContext& context) { return run_references(context, 0.0, "G.10"); }

constexpr Study kStudies[] = {
    {"G.9", "Fixed LQR under added weight: ramps", kRampClaims, run_ramps, kOnTheRigCompliant},
    {"G.10", "Fixed LQR under added weight: steps", kStepClaims, run_steps, kOnTheRigCompliant}};

}  // namespace
}  // namespace chapter9_ramps_studies

std::span<const Study> chapter9_ramps() { return chapter9_ramps_studies::kStudies; }

}  // namespace farrier::thesis
