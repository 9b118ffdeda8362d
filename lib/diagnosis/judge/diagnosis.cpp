#include "diagnosis/judge/diagnosis.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/judge/not_judged.hpp"
#include "diagnosis/judge/parallel.hpp"
#include "diagnosis/data/sample_statistics.hpp"
#include "diagnosis/model/twin.hpp"
#include "diagnosis/model/joint_model.hpp"
#include "diagnosis/model/sides_of_joint.hpp"
#include "robot/joint_scales.hpp"

namespace farrier::diagnosis {
namespace {

/// Least ratio of a recording's signals to its sensors' noise: below it nothing can be judged.
constexpr double kLeastExcitation = 10.0;

/// Effects that a joint may have.
std::vector<plant::EffectId> all_effects(const JointSides& joint) {
  std::vector<plant::EffectId> all;
  for (plant::EffectId id = 0; id < plant::kNameableCount; ++id) {
    if (const ChannelMask shows = joint.channels(id); meet(shows, shows)) {
      all.push_back(id);
    }
  }
  return all;
}

/// Rules for an electric joint. Fits of its few effects are quick, so that none is passed over. Its
/// effects leave less beside the sensors' noise than those of oil.
Rules rules_of_electric(Rules rules) {
  rules.screens = false;
  rules.unexplained = std::min(rules.unexplained, 0.1);
  return rules;
}

/// Experiments that tell the alternatives apart. Those of electric joints are not planned.
std::vector<Experiment> telling_experiments(const JointSides& sides, const Judgement& judgement,
                                            const SensorNoiseLevels& noise, double stroke) {
  const auto* const hydraulic = dynamic_cast<const JointModel*>(&sides);
  std::vector<Experiment> experiments;
  for (std::size_t i = 0; hydraulic != nullptr && i < judgement.alternatives.size(); ++i) {
    Hypothesis chosen = judgement.rivals[i];
    chosen.effects.back() = judgement.alternatives[i].first;
    // Restores the chosen effect with its numbers in place of the rival.
    for (std::size_t half = 0; half < 2; ++half) {
      auto& effects = chosen.halves[half].model.effects;
      const auto& all = judgement.chosen.halves[half].model.effects;
      effects.back() = *std::ranges::find(all, chosen.effects.back(), &Model::Effect::id);
    }
    experiments.push_back(telling_experiment(*hydraulic, chosen, judgement.rivals[i], noise, 0.5 * stroke));
  }
  return experiments;
}

}  // namespace

Diagnosis diagnose(const Recording& recording, const robot::Joint& joint, const DiagnosisOptions& options) {
  Diagnosis result;
  result.remarks = recording.remarks;
  const std::unique_ptr<JointSides> sides = sides_of(joint);
  const double velocity_noise = recording.velocity_derived ? recording.derived_velocity_noise : joint.noise.velocity;
  const SensorNoiseLevels noise{std::hypot(joint.noise.position, recording.position_error),
                                std::hypot(velocity_noise, recording.velocity_error),
                                std::hypot(joint.noise.force, recording.force_error)};
  const bool moves = standard_deviation(recording.position) > kLeastExcitation * noise.position;
  const bool pushes = standard_deviation(recording.force) > kLeastExcitation * noise.force;
  if (!moves && !pushes) {
    result.judgement.verdict = Verdict::kNotExcited;
    result.judgement.not_judged = all_effects(*sides);
    result.remarks.push_back(
        "neither position nor force rises above ten times its sensor's noise: record a joint that moves");
    return result;
  }
  const JointData data = sides->prepared(recording, noise.position);
  const ChannelMask judged{!recording.valve_current_A.empty(), true, !recording.velocity_derived};
  const JointSimulator simulator(*sides, data, noise.force);
  const Bench bench(simulator, judged, options.fit);
  const auto expected = [&](const Hypothesis& hypothesis) {
    return expected_residuals(bench, simulator, hypothesis, noise);
  };
  const Rules rules = joint.electric ? rules_of_electric(options.rules) : options.rules;
  result.judgement = judge(bench, expected, rules, by_threads(options.threads, options.progress, rules.most_effects));
  result.judgement.not_judged =
      not_judged(bench, result.judgement.chosen.halves[0].model, result.judgement.left, options.rules.least_reduction);
  const Judgement& judgement = result.judgement;
  result.channels = report_channels(bench, simulator, judgement.base, judgement.chosen);
  result.experiments = telling_experiments(*sides, judgement, noise, joint.actuator.stroke);
  const ErrorRatio ratio = bench.error_ratio(judgement.base, judgement.chosen);
  result.nrmse_before = ratio.before;
  result.nrmse_after = ratio.after;
  result.ratio_low = ratio.low;
  result.ratio_high = ratio.high;
  options.progress(1.0);
  return result;
}

std::vector<plant::ActiveEffect> found_effects(const Diagnosis& diagnosis, const robot::Joint& joint) {
  const plant::Scales scales = robot::scales_of(joint);
  std::vector<plant::ActiveEffect> effects;
  for (const NamedEffect& effect : diagnosis.judgement.effects) {
    effects.push_back(plant::active_effect(effect.id, effect.fitted, scales));
  }
  return effects;
}

}  // namespace farrier::diagnosis
