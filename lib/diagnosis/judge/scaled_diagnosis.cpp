#include "diagnosis/judge/scaled_diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/data/derive_velocity.hpp"
#include "diagnosis/judge/parallel.hpp"
#include "diagnosis/data/sample_statistics.hpp"
#include "diagnosis/model/scaled_simulator.hpp"
#include "plant/terms/active_effect.hpp"

namespace farrier::diagnosis {
namespace {

/// Blocks for resampling a recording: errors of a simulation that runs freely are correlated for long.
constexpr double kBlocks = 16.0;

constexpr ChannelMask kJudged{true, false, false};

constexpr plant::EffectId kBias = plant::effect_id<plant::ValveBias>();

/// True if an effect makes the valve nonlinear, so that an offset before it differs from a drift behind it.
bool bends(plant::EffectId id) {
  return id == plant::effect_id<plant::ValveDeadband>() || id == plant::effect_id<plant::ValveAsymmetry>() ||
         id == plant::effect_id<plant::FlowSaturation>();
}

/// Positions of the second half by the fit to the first.
std::vector<double> held_out(const Bench& bench, const Hypothesis& hypothesis) {
  return bench.simulator().simulate(bench.halves()[1], hypothesis.halves[0].model, ScaledSimulator::kChannel, {});
}

std::vector<EffectAlone> try_alone(const Bench& bench, const Judgement& judgement, std::span<const double> measured) {
  std::vector<EffectAlone> alone;
  for (plant::EffectId id = 0; id < plant::kEffectCount; ++id) {
    const auto sketch = id == kBias ? std::nullopt : bench.sketch(judgement.base, id, bench.simulator().starts(id));
    const auto with = sketch ? bench.with(judgement.base, *sketch, -std::numeric_limits<double>::infinity())
                             : std::optional<Hypothesis>();
    if (!with) {
      continue;
    }
    const bool accepted =
        !judgement.rounds.empty() && std::ranges::any_of(judgement.rounds.front(), [id](const Candidate& candidate) {
          return candidate.id == id && candidate.accepted;
        });
    const FitResult& first = with->halves[0];
    const std::vector<double>& fitted = first.model.effects[0].fitted;
    alone.push_back({id, fitted, first.deviation[0], fit_percent(measured, held_out(bench, *with)), accepted});
  }
  return alone;
}

}  // namespace

double fit_percent(std::span<const double> measured, std::span<const double> simulated) {
  const double middle = mean(measured);
  double error = 0.0;
  double power = 0.0;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    error += (measured[i] - simulated[i]) * (measured[i] - simulated[i]);
    power += (measured[i] - middle) * (measured[i] - middle);
  }
  return 100.0 * (1.0 - std::sqrt(error / power));
}

ScaledDiagnosis diagnose_scaled(const ScaledRecording& recording, const DiagnosisOptions& options) {
  const ScaledSimulator simulator(recording);
  FitOptions fit = options.fit;
  fit.warm_up_s = 0.0;
  fit.most_iterations = 50;
  fit.tolerance = 1e-8;
  fit.block_s = ScaledSimulator::kSample_s * std::floor(static_cast<double>(recording.position.size()) / kBlocks);
  const Bench bench(simulator, kJudged, fit);
  // Noise of a position at its sample, and of the mean where the simulation begins.
  const double expected = white_noise(recording.position) * std::sqrt(1.0 + 1.0 / ScaledSimulator::kFirst);
  Rules rules = options.rules;
  rules.screens = false;  // a simulation that runs freely is far from linear, and fits of six effects are quick
  if (std::sqrt(bench.base().total(0) / static_cast<double>(simulator.size())) < rules.open_ratio * expected) {
    rules.most_effects = 0;  // nothing is left that an effect could explain
  }
  Judgement judgement = judge(
      bench,
      [expected](const Hypothesis&) {
        return std::array<double, kChannels>{expected, 0.0, 0.0};
      },
      rules, by_threads(options.threads, options.progress, rules.most_effects));
  for (plant::EffectId id = 0; id < plant::kEffectCount; ++id) {
    const bool drift = id == kBias && std::ranges::none_of(judgement.chosen.effects, bends);
    if (drift || simulator.starts(id).empty()) {
      judgement.not_judged.push_back(id);
    }
  }
  const Span second = bench.halves()[1];
  const std::span<const double> measured = std::span(recording.position).subspan(second.begin, second.size());
  const std::vector<double> before = held_out(bench, judgement.base);
  const std::vector<double> after = held_out(bench, judgement.chosen);
  const Model& base = judgement.base.halves[0].model;
  const Model& chosen = judgement.chosen.halves[0].model;
  return {.judgement = judgement,
          .scales = simulator.scales(),
          .gain_before = base.factors[0],
          .drift_before = base.factors[1],
          .gain_after = chosen.factors[0],
          .drift_after = chosen.factors[1],
          .fit_before_percent = fit_percent(measured, before),
          .fit_after_percent = fit_percent(measured, after),
          .error = bench.error_ratio(judgement.base, judgement.chosen),
          .alone = try_alone(bench, judgement, measured),
          .held_out_begin = second.begin,
          .measured = {measured.begin(), measured.end()},
          .before = before,
          .after = after,
          .remarks = recording.remarks};
}

}  // namespace farrier::diagnosis
