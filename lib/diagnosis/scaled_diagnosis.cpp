#include "diagnosis/scaled_diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "diagnosis/derive_velocity.hpp"
#include "diagnosis/parallel.hpp"
#include "diagnosis/sample_statistics.hpp"
#include "diagnosis/scaled_simulator.hpp"

namespace farrier::diagnosis {
namespace {

/// Blocks that a recording is resampled in: errors of a simulation that runs freely go together for long.
constexpr double kBlocks = 16.0;

constexpr ChannelMask kJudged{true, false, false};

/// Positions of the second half by the fit to the first.
std::vector<double> held_out(const Bench& bench, const Hypothesis& hypothesis) {
  return bench.simulator().simulate(bench.halves()[1], hypothesis.halves[0].model, ScaledSimulator::kChannel, {});
}

std::vector<EffectAlone> try_alone(const Bench& bench, const Judgement& judgement, std::span<const double> measured) {
  std::vector<EffectAlone> alone;
  for (plant::EffectId id = 0; id < plant::kEffectCount; ++id) {
    const auto with = bench.with(judgement.base, id, -std::numeric_limits<double>::infinity());
    if (!with) {
      continue;
    }
    const plant::EffectInfo& info = plant::effect_info(id);
    const bool accepted = std::ranges::any_of(judgement.rounds.front(), [id](const Candidate& candidate) {
      return candidate.id == id && candidate.accepted;
    });
    const FitResult& first = with->halves[0];
    const std::vector<double>& fitted = first.model.effects[0].fitted;
    // Where a size ends at 0 the solver leaves gain and drift beside their best: what fits best is the linear model.
    const bool neutral = std::abs(fitted[0] - bench.simulator().scales().neutral(info.parameters[0])) <= 0.0;
    alone.push_back({id, fitted, first.deviation[0],
                     fit_percent(measured, held_out(bench, neutral ? judgement.base : *with)), accepted});
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
  // Noise of a position at its sample, and at the first, where the simulation begins.
  const double expected = std::numbers::sqrt2 * white_noise(recording.position);
  Judgement judgement = judge(
      bench, [expected](const Hypothesis&) { return std::array<double, kChannels>{expected, 0.0, 0.0}; },
      options.rules, by_threads(options.threads, options.progress, options.rules.most_effects));
  for (plant::EffectId id = 0; id < plant::kEffectCount; ++id) {
    if (simulator.starts(id).empty()) {
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
