#include "diagnosis/judge/diagnosis.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/judge/joint_bench.hpp"
#include "diagnosis/judge/not_judged.hpp"
#include "diagnosis/judge/parallel.hpp"
#include "diagnosis/model/sides_of_joint.hpp"
#include "robot/joint_scales.hpp"

namespace farrier::diagnosis {
namespace {

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
  rules.confidence = &confidence_map(true);
  return rules;
}

/// Experiments that tell the alternatives apart.
std::vector<Experiment> telling_experiments(const JointSides& sides, const Judgement& judgement,
                                            const SensorNoiseLevels& noise) {
  std::vector<Experiment> experiments;
  for (std::size_t i = 0; i < judgement.alternatives.size(); ++i) {
    const auto [named, rival] = judgement.alternatives[i];
    const Model& with_rival = judgement.rivals[i].halves[0].model;
    // The same constants in both: fits of this recording have set them apart, and those of the next one will not.
    Model with_named = with_rival;
    *std::ranges::find(with_named.effects, rival, &Model::Effect::id) =
        *std::ranges::find(judgement.chosen.halves[0].model.effects, named, &Model::Effect::id);
    experiments.push_back(telling_experiment(sides, judgement.alternatives[i], with_named, with_rival, noise));
  }
  return experiments;
}

}  // namespace

Diagnosis diagnose(const Recording& recording, const robot::Joint& joint, const DiagnosisOptions& options) {
  Diagnosis result;
  result.remarks = recording.remarks;
  if (!JointBench::is_excited(recording, JointBench::noise_of(recording, joint))) {
    result.judgement.verdict = Verdict::kNotExcited;
    result.judgement.not_judged = all_effects(*sides_of(joint));
    result.remarks.push_back(
        "neither position nor force rises above ten times its sensor's noise: record a joint that moves");
    return result;
  }
  const JointBench of_joint(recording, joint, options.fit);
  const Bench& bench = of_joint.bench();
  const Rules rules = joint.electric ? rules_of_electric(options.rules) : options.rules;
  result.judgement =
      judge(bench, of_joint.expected(), rules, by_threads(options.threads, options.progress, rules.most_effects));
  result.judgement.not_judged =
      not_judged(bench, result.judgement.chosen.halves[0].model, result.judgement.left, options.rules.least_reduction);
  const Judgement& judgement = result.judgement;
  result.channels = report_channels(bench, of_joint.simulator(), judgement.base, judgement.chosen);
  result.experiments = telling_experiments(of_joint.sides(), judgement, of_joint.noise());
  const ErrorRatio ratio = bench.error_ratio(judgement.base, judgement.chosen);
  result.nrmse_before = ratio.before;
  result.nrmse_after = ratio.after;
  result.ratio_low = ratio.low;
  result.ratio_high = ratio.high;
  options.progress(1.0);
  return result;
}

ErrorRatio error_ratio(const Recording& recording, const robot::Joint& given, const robot::Joint& extended,
                       const FitOptions& options) {
  const JointBench before(recording, given, options);
  const JointBench after(recording, extended, options);
  return before.bench().error_ratio(before.bench().base(), after.bench().base());
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
