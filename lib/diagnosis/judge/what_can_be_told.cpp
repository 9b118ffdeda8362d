#include "diagnosis/judge/what_can_be_told.hpp"

#include <algorithm>

#include "diagnosis/judge/joint_bench.hpp"
#include "diagnosis/judge/parallel.hpp"
#include "diagnosis/model/joint_model.hpp"

namespace farrier::diagnosis {
namespace {

constexpr std::size_t kRounds = 6;  // of parallel work, for the progress

/// A channel that is not judged and on which one of two effects alone shows.
std::optional<Channel> telling_column(const Simulator& simulator, const ChannelMask& judged, plant::EffectId one,
                                      plant::EffectId other) {
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (!judged[c] && simulator.channels(one)[c] != simulator.channels(other)[c]) {
      return static_cast<Channel>(c);
    }
  }
  return std::nullopt;
}

Hypothesis with_effect(const Hypothesis& base, plant::EffectId id, const std::vector<double>& numbers) {
  Hypothesis with = base;
  with.effects.push_back(id);
  for (FitResult& half : with.halves) {
    half.model.effects.push_back({id, numbers});
  }
  return with;
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
        pairs.push_back({{one.id, rival.id, rival.left, std::nullopt, std::nullopt}, one.size, rival.fitted});
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
  const Hypothesis base = bench.base();
  WhatCanBeTold told;
  told.effects = effect_visibilities(bench, base.halves[0].model, of_joint.expected()(base), options.rules, for_each);
  for (plant::EffectId id = 0; id < plant::kNameableCount; ++id) {
    const ChannelMask shows = simulator.channels(id);
    if (meet(shows, shows) && !meet(shows, judged)) {
      told.other_columns.push_back(id);
    }
  }
  std::vector<Pair> pairs = alike(told.effects);
  const auto* const hydraulic = dynamic_cast<const JointModel*>(&of_joint.sides());
  for_each(pairs.size(), [&](std::size_t i) {
    Pair& pair = pairs[i];
    pair.found.column = telling_column(simulator, judged, pair.found.one, pair.found.other);
    if (!pair.found.column && hydraulic != nullptr) {
      const Experiment best = telling_experiment(*hydraulic, with_effect(base, pair.found.one, pair.size),
                                                 with_effect(base, pair.found.other, pair.like), of_joint.noise(),
                                                 0.5 * joint.actuator.stroke);
      pair.found.experiment = best.difference > kTellingDifference ? std::optional(best) : std::nullopt;
    }
  });
  std::ranges::transform(pairs, std::back_inserter(told.pairs), &Pair::found);
  options.progress(1.0);
  return told;
}

}  // namespace farrier::diagnosis
