#include "diagnosis/separability/separability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "diagnosis/separability/changes.hpp"
#include "diagnosis/judge/selection.hpp"

namespace farrier::diagnosis {
namespace {

/// Most alike effects whose remainders are settled; those of the others are of one linear step.
constexpr std::size_t kSettled = 2;

/// The least change that an effect is named by.
struct Enough {
  const Rules& rules;
  std::array<double, kChannels> whole;  ///< rms change of all effects by channel, over the noise
  double step;                          ///< of a channel's rms before any effect, that must be explained

  /// Factor of an effect's size by which its remainder `left` would be just enough: below 1, it is more than enough. The change of
  /// the other effects stays.
  double factor(const std::array<double, kChannels>& left) const noexcept {
    double factor = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < kChannels; ++c) {
      const double rest = std::sqrt(std::max(0.0, whole[c] * whole[c] - left[c] * left[c]));
      const double of_whole = step * std::hypot(1.0, rest) / std::sqrt(1.0 - step * step);
      const double least = std::max(visible_beside_noise(rules.least_reduction), of_whole);
      factor = std::min(factor, least / std::max(left[c], 1e-300));
    }
    return factor;
  }
  bool by_change(const std::array<double, kChannels>& left) const noexcept { return factor(left) < 1.0; }
};

/// An effect that may stand for another one, with its remainder.
struct Rival {
  plant::EffectId id;
  Changes::Left left;
};

/// Effects of `others` that leave less of a target's change than a clear lead, the most alike first.
std::vector<Rival> rivals_of(const Changes& changes, std::size_t target, const std::vector<plant::EffectId>& others,
                             double clear_lead) {
  const auto largest = [](const Rival& rival) { return rival.left.largest(); };
  std::vector<Rival> rivals;
  for (const plant::EffectId other : others) {
    if (auto left = changes.left_beside(target, other)) {
      rivals.push_back({other, std::move(*left)});
    }
  }
  std::ranges::sort(rivals, {}, largest);
  for (std::size_t i = 0; i < std::min(kSettled, rivals.size()); ++i) {
    rivals[i].left = changes.settled(target, rivals[i].left);
  }
  const double clear = visible_beside_noise(clear_lead);
  std::erase_if(rivals, [clear](const Rival& rival) { return rival.left.largest() >= clear; });
  std::ranges::sort(rivals, {}, largest);
  return rivals;
}

/// Visibility of `effect`, which is a target of `changes`, among `others`. `without` gets the model that explains most in its
/// place.
EffectVisibility visibility_of(const Simulator& simulator, const Changes& changes, std::size_t target,
                               const Model::Effect& effect, const Enough& enough, std::vector<plant::EffectId> others,
                               Model& without) {
  Changes::Left left = changes.left_of(target);
  if (enough.by_change(left.rms)) {
    left = changes.settled(target, left);
  }
  EffectVisibility one{.id = effect.id, .size = effect.fitted, .rivals = {}};
  one.change = left.largest();
  const double neutral = neutral_value(simulator, effect.id);
  const double distance = std::abs(effect.fitted[0] - neutral);
  const double band = neutral_band(simulator, effect.id, enough.rules);
  const double deviation = changes.deviation_of(target);
  one.deviations = std::max(0.0, distance - band) / std::max(deviation, 1e-300);
  // Factor by which the size would be just enough.
  const double factor = std::max(enough.factor(left.rms),
                                 (band + enough.rules.neutral_deviations * deviation) / std::max(distance, 1e-300));
  one.shows = factor < 1.0;
  one.shows_from = neutral + (effect.fitted[0] - neutral) * factor;
  without = std::move(left.follower);
  if (one.shows) {
    std::erase(others, effect.id);
    std::vector<Rival> rivals = rivals_of(changes, target, others, enough.rules.clear_lead);
    for (const Rival& rival : rivals) {
      one.rivals.push_back({rival.id, rival.left.follower.effects.back().fitted, rival.left.largest()});
    }
    without = rivals.empty() ? std::move(without) : std::move(rivals.front().left.follower);
  }
  return one;
}

std::vector<plant::EffectId> all_effects() {
  std::vector<plant::EffectId> all(plant::kNameableCount);
  std::iota(all.begin(), all.end(), plant::EffectId{0});
  return all;
}

/// Effects that may stand for another one: a general form does so by its special case.
std::vector<plant::EffectId> possible_rivals() {
  std::vector<plant::EffectId> all = all_effects();
  std::erase_if(all, plant::is_general_form);
  return all;
}

/// Effects of the rest without whose help a target's change would be enough, and at least twice what they leave of it.
std::vector<plant::EffectId> hiding(const Changes& changes, const Enough& enough, const Model& rest) {
  std::vector<plant::EffectId> all;
  std::ranges::transform(rest.effects, std::back_inserter(all), &Model::Effect::id);
  if (!enough.by_change(changes.left_of(0, all).rms)) {
    return {};  // the constants alone hide it, or it is too small
  }
  const double left = changes.left_of(0).largest();
  std::vector<plant::EffectId> hide;
  std::ranges::copy_if(all, std::back_inserter(hide), [&](plant::EffectId id) {
    const Changes::Left without = changes.left_of(0, {id});
    return enough.by_change(without.rms) && without.largest() > 2.0 * left;
  });
  return hide.empty() ? all : hide;
}

}  // namespace

std::vector<double> usual_size(const Simulator& simulator, plant::EffectId id) {
  const auto starts = simulator.starts(id);
  if (starts.empty()) {
    return {};
  }
  std::vector<double> fitted = starts.front();
  const plant::EffectInfo& info = plant::effect_info(id);
  const double neutral = simulator.scales().neutral(info.parameters[0]);
  if (info.nominal && neutral != 0.0) {
    fitted[0] = 1.2 * neutral;
  }
  return fitted;
}

std::vector<EffectVisibility> effect_visibilities(const Bench& bench, const Model& model,
                                                  const std::array<double, kChannels>& expected, const Rules& rules,
                                                  const ForEach& for_each) {
  const Simulator& simulator = bench.simulator();
  std::vector<AddedEffects> targets;
  for (const plant::EffectId id : all_effects()) {
    std::vector<double> size = usual_size(simulator, id);
    if (!size.empty() && meet(simulator.channels(id), bench.fit_data().judged) && !model.has(id) &&
        simulator.known(id) == nullptr) {
      targets.push_back({{id, std::move(size)}});
    }
  }
  const Changes changes(bench, model, expected, targets, possible_rivals(), for_each);
  std::vector<EffectVisibility> all(targets.size());
  for_each(all.size(), [&](std::size_t i) {
    const Enough enough{rules, changes.left_of(i).rms, rules.least_step};
    Model without;
    all[i] = visibility_of(simulator, changes, i, targets[i].front(), enough, possible_rivals(), without);
  });
  return all;
}

std::vector<MemberVisibility> member_visibilities(const Bench& bench, const std::vector<Model::Effect>& set,
                                                  const std::array<double, kChannels>& expected, const Rules& rules,
                                                  const ForEach& for_each) {
  const Simulator& simulator = bench.simulator();
  Model whole = simulator.nominal();
  std::ranges::copy_if(set, std::back_inserter(whole.effects),
                       [](const auto& effect) { return !effect.fitted.empty(); });
  const Enough enough{rules,
                      Changes(bench, simulator.nominal(), expected, {whole.effects}, {}, for_each).left_of(0).rms,
                      whole.effects.size() > 1 ? rules.further_step : rules.least_step};
  std::vector<MemberVisibility> members;
  for (const Model::Effect& effect : set) {
    MemberVisibility member;
    member.beside.id = effect.id;
    member.beside.size = effect.fitted;
    member.recorded = meet(simulator.channels(effect.id), bench.fit_data().judged);
    member.without = whole;
    std::erase_if(member.without.effects, [&](const Model::Effect& one) { return one.id == effect.id; });
    if (member.recorded && !effect.fitted.empty()) {
      const Model rest = member.without;
      std::vector<plant::EffectId> outside;
      std::ranges::copy_if(possible_rivals(), std::back_inserter(outside), [&](plant::EffectId id) {
        return !whole.has(id) && meet(simulator.channels(id), simulator.channels(effect.id));
      });
      const Changes changes(bench, rest, expected, {{effect}}, outside, for_each);
      member.beside = visibility_of(simulator, changes, 0, effect, enough, outside, member.without);
      if (!member.beside.shows) {
        member.hidden_by = hiding(changes, enough, rest);
      }
    }
    members.push_back(std::move(member));
  }
  return members;
}

}  // namespace farrier::diagnosis
