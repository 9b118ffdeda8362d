#include "diagnosis/judge/diagnosis.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/judge/not_judged.hpp"
#include "diagnosis/judge/parallel.hpp"
#include "diagnosis/data/sample_statistics.hpp"
#include "diagnosis/model/twin.hpp"
#include "plant/terms/load_effects.hpp"

namespace farrier::diagnosis {
namespace {

/// Effects of the joint's file, except those that are in its load.
std::vector<Model::Effect> known_effects(const robot::Joint& joint, const plant::Scales& scales) {
  std::vector<Model::Effect> known;
  for (const plant::ActiveEffect& effect : joint.effects) {
    if (!plant::is_in_load(effect.id)) {
      const auto fitted = plant::fitted_of(effect, scales);
      known.push_back({effect.id, {fitted.begin(), fitted.begin() + std::ssize(effect.info().parameters)}});
    }
  }
  return known;
}

/// Least ratio of a recording's signals to its sensors' noise: below it nothing can be judged.
constexpr double kLeastExcitation = 10.0;

std::vector<plant::EffectId> all_effects() {
  std::vector<plant::EffectId> all;
  for (plant::EffectId id = 0; id < plant::kEffectCount; ++id) {
    all.push_back(id);
  }
  return all;
}

}  // namespace

Diagnosis diagnose(const Recording& recording, const robot::Joint& joint, const DiagnosisOptions& options) {
  Diagnosis result;
  result.remarks = recording.remarks;
  const double velocity_noise = recording.velocity_derived ? recording.derived_velocity_noise : joint.noise.velocity;
  const SensorNoiseLevels noise{std::hypot(joint.noise.position, recording.position_error),
                                std::hypot(velocity_noise, recording.velocity_error),
                                std::hypot(joint.noise.force, recording.force_error)};
  const bool moves = standard_deviation(recording.position) > kLeastExcitation * noise.position;
  const bool pushes = standard_deviation(recording.force) > kLeastExcitation * noise.force;
  if (!moves && !pushes) {
    result.judgement.verdict = Verdict::kNotExcited;
    result.judgement.not_judged = all_effects();
    result.remarks.push_back(
        "neither position nor force rises above ten times its sensor's noise: record a joint that moves");
    return result;
  }
  const plant::Scales scales(joint.actuator, joint.swing_load);
  const JointModel model(joint.actuator, joint.swing_load, known_effects(joint, scales));
  const JointData data = prepare(recording, joint.actuator, noise.position);
  const ChannelMask judged{!recording.valve_current_A.empty(), true, !recording.velocity_derived};
  const JointSimulator simulator(model, data, noise.force);
  const Bench bench(simulator, judged, options.fit);
  const auto expected = [&](const Hypothesis& hypothesis) {
    return expected_residuals(bench, simulator, hypothesis, noise);
  };
  result.judgement =
      judge(bench, expected, options.rules, by_threads(options.threads, options.progress, options.rules.most_effects));
  result.judgement.not_judged =
      not_judged(bench, result.judgement.chosen.halves[0].model, result.judgement.left, options.rules.least_reduction);
  const Judgement& judgement = result.judgement;
  result.channels = report_channels(bench, simulator, judgement.base, judgement.chosen);
  for (std::size_t i = 0; i < judgement.alternatives.size(); ++i) {
    Hypothesis chosen = judgement.rivals[i];
    chosen.effects.back() = judgement.alternatives[i].first;
    // Restores the chosen effect with its numbers in place of the rival.
    for (std::size_t half = 0; half < 2; ++half) {
      auto& effects = chosen.halves[half].model.effects;
      const auto& all = judgement.chosen.halves[half].model.effects;
      effects.back() = *std::ranges::find(all, chosen.effects.back(), &Model::Effect::id);
    }
    result.experiments.push_back(
        telling_experiment(model, chosen, judgement.rivals[i], noise, 0.5 * joint.actuator.stroke));
  }
  const ErrorRatio ratio = bench.error_ratio(judgement.base, judgement.chosen);
  result.nrmse_before = ratio.before;
  result.nrmse_after = ratio.after;
  result.ratio_low = ratio.low;
  result.ratio_high = ratio.high;
  options.progress(1.0);
  return result;
}

std::vector<plant::ActiveEffect> found_effects(const Diagnosis& diagnosis, const robot::Joint& joint) {
  const plant::Scales scales(joint.actuator, joint.swing_load);
  std::vector<plant::ActiveEffect> effects;
  for (const NamedEffect& effect : diagnosis.judgement.effects) {
    effects.push_back(plant::active_effect(effect.id, effect.fitted, scales));
  }
  return effects;
}

}  // namespace farrier::diagnosis
