// Hubacher (2014), Figs 9.10, G.5 and G.6: gains of the compliant LQR for estimates of the rig, designed off-line.

#include <algorithm>
#include <cmath>

#include "control/design/lqr.hpp"
#include "thesis/rig/rig_conditions.hpp"
#include "thesis/studies/registry.hpp"
#include "thesis/rig/rig_estimates.hpp"

namespace farrier::thesis {
namespace chapter9_gains_studies {
namespace {

using estimation::GateKind;

/// Gains of the compliant LQR for each estimate; NaN where there is no design.
struct GainTrack {
  std::vector<double> velocity, force;
};

GainTrack gains_of(const ChirpEstimates& run) {
  // The models are normalised already.
  const control::Normalisation unit{1.0, 1.0, 1.0, 1.0};
  GainTrack track;
  for (const control::DiscreteModel& model : run.models) {
    const auto gains = control::design_lqr(model, control::LqrWeights{}, unit, control::Form::kCompliant, 0);
    track.velocity.push_back(gains ? gains.value().velocity : std::nan(""));
    track.force.push_back(gains ? gains.value().force : std::nan(""));
  }
  return track;
}

double median(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) {
    return std::nan("");
  }
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

std::vector<double> between(const ChirpEstimates& run, const std::vector<double>& values, double from_s, double to_s) {
  std::vector<double> some;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (run.time_s[i] >= from_s && run.time_s[i] < to_s) {
      some.push_back(values[i]);
    }
  }
  return some;
}

/// From when on, within the first 1.5 s, the gain stays within a quarter of its median there from 0.5 s on.
double settled_s(const ChirpEstimates& run, const std::vector<double>& gain) {
  const double steady = median(between(run, gain, 0.5, 1.5));
  double last = 0.0;
  for (std::size_t i = 0; i < gain.size() && run.time_s[i] < 1.5; ++i) {
    if (!(std::abs(gain[i] - steady) <= 0.25 * std::abs(steady))) {
      last = run.time_s[i];
    }
  }
  return last;
}

/// Mean size of the gain's change in 20 ms between two times, over its median there.
double jitter(const ChirpEstimates& run, const std::vector<double>& gain, double from_s, double to_s) {
  const std::vector<double> some = between(run, gain, from_s, to_s);
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 1; i < some.size(); ++i) {
    if (std::isfinite(some[i]) && std::isfinite(some[i - 1])) {
      sum += std::abs(some[i] - some[i - 1]);
      count += 1.0;
    }
  }
  return sum / count / std::abs(median(some));
}

std::vector<Panel> gain_panels(const std::string& title, const ChirpEstimates& run, const GainTrack& track) {
  std::vector<double> shade;
  for (std::size_t i = 0; i < run.models.size(); ++i) {
    shade.push_back(static_cast<double>(i) / static_cast<double>(run.models.size()));
  }
  std::vector<Panel> panels;
  for (const auto& [name, values] : {std::pair{"velocity", &track.velocity}, std::pair{"force", &track.force}}) {
    const double size = 5.0 * std::abs(median(*values));
    std::vector<double> cut(*values);
    std::ranges::for_each(cut, [=](double& value) { value = std::clamp(value, -size, size); });
    panels.push_back({.title = title + ": " + name,
                      .x_label = "time (s)",
                      .y_label = "gain, normalised (1)",
                      .series = {{"", run.time_s, std::move(cut), Style::kPoints, 0, shade}}});
  }
  return panels;
}

constexpr const char* kSteady =
    "Observe how the controller gains increase steadily and reach steady-state after about 0.3 s.";
constexpr const char* kFirstPeriod =
    "by 0.3 s a chirp of 0 to 30 Hz in 8 s has turned by 61 degrees, too little for 12 parameters; covariances of 1 to "
    "1e5, c_1 of 1 to "
    "256 and perfect measurements do not bring both below 0.5 s. The text's rig was excited at the beginning by \"the "
    "pressure builds up and "
    "the piston starts to move\" (9.1.2), with no numbers";
constexpr const char* kLessSmooth =
    "The evolution is less smooth and it can be questioned if these fast changes at around 4 - 6 s will not lead to "
    "instability ...";

constexpr ClaimSpec kGainClaims[] = {
    fails(
        kFirstPeriod,
        {"9.10.steady_nominal", "9.1.4", kSteady,
         "Time from which on the force gain without weight stays within a quarter of its value at 0.5 to 1.5 s: 0.4 s.",
         "s", Relation::kAtMost, 0.4}),
    fails(kFirstPeriod,
          {"9.10.steady_heavy", "9.1.4", kSteady, "The same with 15 kg added.", "s", Relation::kAtMost, 0.4}),
    {"9.10.less_smooth", "9.1.4", kLessSmooth,
     "Mean relative change of the force gain in 20 ms at 4 to 6 s over that at 0.5 to 1.5 s, without weight: 1.1 or "
     "more.",
     "1", Relation::kAtLeast, 1.1},
    {"9.10.accordingly", "9.1.4",
     "It can be observed how the system changes during the experiment and towards the end of the sequence ...",
     "Distance of the force gain's median in the last second from that at 0.5 to 1.5 s, over it, the larger of both "
     "runs: a tenth or more.",
     "1", Relation::kAtLeast, 0.1}};

/// A run and the gains for its estimates.
struct GainRun {
  ChirpEstimates estimates;
  GainTrack gains;
};

Result<GainRun> run_chirp(const robot::Robot& rig, const ChirpCase& one, std::uint64_t seed) {
  auto estimates = FARRIER_TRY(estimate_chirp(rig, one, seed));
  GainTrack gains = gains_of(estimates);
  return GainRun{std::move(estimates), std::move(gains)};
}

double settled_s(const GainRun& run) { return settled_s(run.estimates, run.gains.force); }

double quickening(const GainRun& run) {
  return jitter(run.estimates, run.gains.force, 4.0, 6.0) / jitter(run.estimates, run.gains.force, 0.5, 1.5);
}

/// By how much the force gain of the last second differs from that of the beginning.
double changed(const GainRun& run) {
  const auto median_of = [&](double from_s, double to_s) {
    return median(between(run.estimates, run.gains.force, from_s, to_s));
  };
  return std::abs(median_of(7.0, kChirp_s) / median_of(0.5, 1.5) - 1.0);
}

Result<StudyResult> run_gains(const StudyContext& context) {
  const auto rig = FARRIER_TRY(load_rig(context));
  const GainRun light = FARRIER_TRY(run_chirp(rig, weighted_chirp(0.0, GateKind::kNone), context.seed));
  const GainRun heavy = FARRIER_TRY(run_chirp(rig, weighted_chirp(15.0, GateKind::kNone), context.seed));
  StudyResult result;
  result.measured = {{"9.10.steady_nominal", settled_s(light), ""},
                     {"9.10.steady_heavy", settled_s(heavy), ""},
                     {"9.10.less_smooth", quickening(light), ""},
                     {"9.10.accordingly", std::max(changed(light), changed(heavy)), ""}};
  const std::vector<Panel> left = gain_panels("+0 kg", light.estimates, light.gains);
  const std::vector<Panel> right = gain_panels("+15 kg", heavy.estimates, heavy.gains);
  result.pictures = {{"Gains of the compliant LQR for the estimates, black to yellow; cut at five times their median",
                      2,
                      {left[0], right[0], left[1], right[1]}}};
  return result;
}

constexpr ClaimSpec kPeGainClaims[] = {
    proof({"G.5.held", "Fig. G.5", "The system estimates were calculated using the AFF and PE algorithm ...",
           "Largest change of the force gain in 20 ms while the gate is closed.", "1", Relation::kAtMost, 1e-12})};
constexpr ClaimSpec kFftGainClaims[] = {
    proof({"G.6.held", "Fig. G.6", "The system estimates were calculated using the AFF and FFT algorithm ...",
           "Largest change of the force gain in 20 ms while the gate is closed.", "1", Relation::kAtMost, 1e-12})};

Result<StudyResult> run_gated_gains(const StudyContext& context, GateKind gate, const char* id) {
  const auto rig = FARRIER_TRY(load_rig(context));
  const auto made = FARRIER_TRY(run_chirp(rig, weighted_chirp(0.0, gate), context.seed));
  const ChirpEstimates& run = made.estimates;
  const GainTrack& track = made.gains;
  const auto each = static_cast<std::size_t>(std::llround(kModel_s / run.period_s));
  double largest = 0.0;
  double held = 0.0;
  for (std::size_t i = 1; i < run.models.size(); ++i) {
    const auto begin = run.open.begin() + static_cast<std::ptrdiff_t>(i * each);
    const bool closed = std::none_of(begin, begin + static_cast<std::ptrdiff_t>(each), [](bool open) { return open; });
    const double change = std::abs(track.force[i] - track.force[i - 1]);
    if (closed && std::isfinite(change)) {
      largest = std::max(largest, change);
      held += 1.0;
    }
  }
  StudyResult result;
  result.measured = {{id, largest, number_as("held for %.1f s of 8", held * kModel_s)}};
  result.pictures = {{"Gains of the compliant LQR for the estimates, black to yellow; cut at five times their median",
                      1, gain_panels("+0 kg", run, track)}};
  return result;
}

Result<StudyResult> run_pe_gains(const StudyContext& context) {
  return run_gated_gains(context, GateKind::kPe, "G.5.held");
}
Result<StudyResult> run_fft_gains(const StudyContext& context) {
  return run_gated_gains(context, GateKind::kFft, "G.6.held");
}

constexpr Study kStudies[] = {
    {"9.10", "Gains for the estimates", kGainClaims, run_gains, kOnTheRigEstimated},
    {"G.5", "Gains for the estimates behind the PE gate", kPeGainClaims, run_pe_gains, kOnTheRigEstimated},
    {"G.6", "Gains for the estimates behind the FFT gate", kFftGainClaims, run_fft_gains, kOnTheRigEstimated}};

}  // namespace
}  // namespace chapter9_gains_studies

std::span<const Study> chapter9_gains() { return chapter9_gains_studies::kStudies; }

}  // namespace farrier::thesis
