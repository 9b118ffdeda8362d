#include "diagnosis/separability/what_can_be_told.hpp"

#include <algorithm>

#include "diagnosis/judge/joint_bench.hpp"
#include "diagnosis/judge/parallel.hpp"
#include "diagnosis/model/sides_of_joint.hpp"

namespace farrier::diagnosis {
namespace {

constexpr std::size_t kRounds = 6;  // of parallel work, for the progress

/// A channel that is not judged and on which `one` alone shows, or all of `others` and not `one`.
std::optional<Channel> telling_column(const Simulator& simulator, const ChannelMask& judged, plant::EffectId one,
                                      const std::vector<plant::EffectId>& others) {
  const ChannelMask mine = simulator.channels(one);
  for (std::size_t c = 0; c < kChannels; ++c) {
    const auto differs = [&](plant::EffectId other) { return simulator.channels(other)[c] != mine[c]; };
    if (!judged[c] && (others.empty() ? mine[c] : std::ranges::all_of(others, differs))) {
      return static_cast<Channel>(c);
    }
  }
  return std::nullopt;
}

Model with_effect(Model model, plant::EffectId id, const std::vector<double>& numbers) {
  model.effects.push_back({id, numbers});
  return model;
}

/// The experiment under which joints of both models differ enough, if one was found. They differ in their last effects.
std::optional<Experiment> experiment_for(const JointBench& of_joint, const Model& one, const Model& other) {
  const plant::EffectId last = one.effects.back().id;
  const Experiment best = telling_experiment(
      of_joint.sides(), {last, other.effects.empty() ? last : other.effects.back().id}, one, other, of_joint.noise());
  return best.tells() ? std::optional(best) : std::nullopt;
}

/// A pair, with the numbers of the effect that explains the other.
struct Pair {
  Inseparable found;
  std::vector<double> size, like;
};

std::vector<Pair> alike(const std::vector<EffectVisibility>& effects) {
  std::vector<Pair> pairs;
  for (const EffectVisibility& one : effects) {
    for (const LikeEffect& rival : one.rivals) {
      const auto known = std::ranges::find_if(
          pairs, [&](const Pair& pair) { return pair.found.one == rival.id && pair.found.other == one.id; });
      if (known == pairs.end()) {
        pairs.push_back({{one.id, rival.id, rival.left, {}}, one.size, rival.fitted});
      } else {
        known->found.left = std::min(known->found.left, rival.left);
      }
    }
  }
  std::ranges::sort(pairs, {}, [](const Pair& pair) { return pair.found.left; });
  return pairs;
}

}  // namespace

WhatCanBeTold what_can_be_told(const Recording& recording, const robot::Joint& joint, const DiagnosisOptions& options) {
  const JointBench of_joint(recording, joint, options.fit);
  const Bench& bench = of_joint.bench();
  const Simulator& simulator = bench.simulator();
  const ChannelMask& judged = bench.fit_data().judged;
  const ForEach for_each = by_threads(options.threads, options.progress, kRounds);
  const Model nominal = simulator.nominal();
  WhatCanBeTold told;
  told.effects = effect_visibilities(bench, nominal, of_joint.expected_of(nominal), options.rules, for_each);
  for (plant::EffectId id = 0; id < plant::kNameableCount; ++id) {
    const ChannelMask shows = simulator.channels(id);
    if (meet(shows, shows) && !meet(shows, judged)) {
      told.other_columns.push_back(id);
    }
  }
  std::vector<Pair> pairs = alike(told.effects);
  for_each(pairs.size(), [&](std::size_t i) {
    Pair& pair = pairs[i];
    Remedy& remedy = pair.found.remedy;
    remedy.column = telling_column(simulator, judged, pair.found.one, {pair.found.other});
    if (!remedy.column) {
      remedy.experiment = experiment_for(of_joint, with_effect(nominal, pair.found.one, pair.size),
                                         with_effect(nominal, pair.found.other, pair.like));
    }
  });
  std::ranges::transform(pairs, std::back_inserter(told.pairs), &Pair::found);
  options.progress(1.0);
  return told;
}

std::vector<ToldMember> what_can_be_told(const Recording& recording, const robot::Joint& joint,
                                         const std::vector<plant::EffectId>& set, const DiagnosisOptions& options) {
  const JointBench of_joint(recording, joint, options.fit);
  const Bench& bench = of_joint.bench();
  const Simulator& simulator = bench.simulator();
  const ForEach for_each = by_threads(options.threads, options.progress, kRounds * set.size());
  std::vector<Model::Effect> sized;
  std::ranges::transform(set, std::back_inserter(sized), [&](plant::EffectId id) {
    return Model::Effect{id, usual_size(simulator, id)};
  });
  std::vector<ToldMember> told;
  for (MemberVisibility& seen :
       member_visibilities(bench, sized, of_joint.expected_of(simulator.nominal()), options.rules, for_each)) {
    told.push_back({std::move(seen), {}});
  }
  for_each(told.size(), [&](std::size_t i) {
    const MemberVisibility& seen = told[i].seen;
    Remedy& remedy = told[i].remedy;
    if (seen.separable()) {
      return;
    }
    std::vector<plant::EffectId> hide = seen.hidden_by;
    std::ranges::transform(seen.beside.rivals, std::back_inserter(hide), &LikeEffect::id);
    remedy.column = telling_column(simulator, bench.fit_data().judged, seen.beside.id, hide);
    if (!remedy.column && !seen.beside.size.empty()) {
      Model whole = simulator.nominal();
      std::ranges::copy_if(sized, std::back_inserter(whole.effects), [&](const Model::Effect& effect) {
        return effect.id != seen.beside.id && !effect.fitted.empty();
      });
      remedy.experiment = experiment_for(of_joint, with_effect(whole, seen.beside.id, seen.beside.size), seen.without);
    }
  });
  options.progress(1.0);
  return told;
}

std::vector<plant::EffectId> can_be_asked(const robot::Joint& joint) {
  const auto sides = sides_of(joint);
  std::vector<plant::EffectId> all;
  for (plant::EffectId id = 0; id < plant::kNameableCount; ++id) {
    const ChannelMask shows = sides->channels(id);
    if (meet(shows, shows) && sides->known(id) == nullptr) {
      all.push_back(id);
    }
  }
  return all;
}

}  // namespace farrier::diagnosis
