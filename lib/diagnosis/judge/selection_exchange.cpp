#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "diagnosis/judge/screening.hpp"
#include "diagnosis/judge/selection.hpp"
#include "diagnosis/separability/separability.hpp"

namespace farrier::diagnosis {

bool Selection::may_be_rivals(plant::EffectId one, plant::EffectId other) const {
  return meet(bench_.simulator().channels(one), bench_.simulator().channels(other));
}

std::ptrdiff_t Selection::channel_count(plant::EffectId id) const {
  return std::ranges::count(bench_.simulator().channels(id), true);
}

double Selection::chance_of(const Hypothesis& one, const Hypothesis& other) const {
  const Gain lead = bench_.gain(other, one);
  const auto left = remainder(bench_, one, expected_);
  double clearest = 0.0;
  double over_structure = 0.0;
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (bench_.fit_data().judged[c] && std::abs(lead.reduction[c]) > clearest) {
      clearest = std::abs(lead.reduction[c]);
      const double step = std::abs(other.total(c) / one.total(c) - 1.0);
      const double noise = std::min(1.0, left[c].expected / std::max(left[c].rms, 1e-300));
      over_structure = step / std::max(1.0 - noise * noise, 1e-12);
    }
  }
  const double trust = std::min({1.0, clearest / rules_.clear_lead, over_structure / rules_.clear_structure});
  return 0.5 + (lead.chance - 0.5) * trust;
}

void Selection::note_rivals(const std::vector<Tried>& tried, plant::EffectId best) {
  const auto numbers = [&](plant::EffectId id) {
    const auto& halves = tried[id].hypothesis->halves;
    return std::array{halves[0].model.effects.back().fitted, halves[1].model.effects.back().fitted};
  };
  for (plant::EffectId id = 0; id < plant::kNameableCount; ++id) {
    const bool near = tried[id].accepted && id != best && may_be_rivals(id, best) &&
                      tried[id].gain.log_ratio > rules_.least_exchange * tried[best].gain.log_ratio;
    if (near) {
      rivals_[{best, id}] = numbers(id);
      rivals_[{id, best}] = numbers(best);
    }
  }
}

const Hypothesis& Selection::without(plant::EffectId effect) {
  const auto known = without_.find(effect);
  return known != without_.end() ? known->second
                                 : without_.emplace(effect, bench_.without(chosen_, effect)).first->second;
}

void Selection::choose(Hypothesis hypothesis) {
  chosen_ = std::move(hypothesis);
  without_.clear();
}

bool Selection::adds_to(const Hypothesis& less, const Hypothesis& with, bool once) const {
  const Gain gain = bench_.gain(less, with);
  return (once || gain.low > 0.0) && *std::ranges::max_element(gain.reduction) > 0.5 * rules_.least_reduction;
}

bool Selection::is_needed(std::size_t index) {
  const plant::EffectId id = chosen_.effects[index];
  return outside_neutral(id, pooled(chosen_, index)) &&
         adds_to(without(id), chosen_, std::ranges::find(once_, id) != once_.end());
}

std::vector<Selection::RivalStart> Selection::promised_rivals(const Hypothesis& less, plant::EffectId effect) {
  const double mine = std::max(bench_.gain(less, chosen_).log_ratio, 1e-12);
  const Screening screening(bench_, less);
  std::vector<RivalStart> rivals(plant::kNameableCount);
  for_each_(plant::kNameableCount, [&](std::size_t id) {
    if (may_be_rivals(id, effect) && may_be_added(chosen_, id)) {
      const Screening::Promise promise = screening.promise_of(id);
      rivals[id] = {id, promise.start, promise.log_ratio / mine};
    }
  });
  std::erase_if(rivals, [](const RivalStart& rival) { return rival.start.empty(); });
  std::ranges::stable_sort(rivals, std::greater{}, &RivalStart::share);
  runner_up_[effect] = std::max(runner_up_[effect], rivals.empty() ? 0.0 : rivals.front().share);
  std::erase_if(rivals, [this](const RivalStart& rival) { return rival.share < rules_.least_exchange; });
  rivals.resize(std::min(rivals.size(), rules_.most_exchanged));
  return rivals;
}

std::vector<std::pair<plant::EffectId, Hypothesis>> Selection::rivals_of(plant::EffectId effect) {
  const Hypothesis& less = without(effect);
  runner_up_[effect] = 0.0;
  std::vector<std::pair<plant::EffectId, Hypothesis>> rivals;
  const std::vector<RivalStart> in_place = promised_rivals(bench_.cut(chosen_, effect), effect);
  for (const RivalStart& rival : in_place) {
    rivals.emplace_back(rival.id, bench_.exchanged(chosen_, effect, rival.id, {rival.start, rival.start}));
  }
  for (const RivalStart& rival : promised_rivals(less, effect)) {
    if (std::ranges::find(in_place, rival.id, &RivalStart::id) != in_place.end()) {
      continue;
    }
    auto with = bench_.with(less, bench_.sketch(less, {{rival.id, rival.start}}), 0.5 * rules_.least_reduction);
    if (with) {
      rivals.emplace_back(rival.id, std::move(*with));
    }
  }
  for (const auto& [pair, fitted] : rivals_) {
    if (pair.first == effect && may_be_added(chosen_, pair.second)) {
      rivals.emplace_back(pair.second, bench_.exchanged(chosen_, effect, pair.second, fitted));
    }
  }
  return rivals;
}

bool Selection::are_tied(plant::EffectId chosen, plant::EffectId rival) const {
  return std::ranges::any_of(ties_, [&](const Tie& tie) { return tie.chosen == chosen && tie.rival == rival; });
}

void Selection::note_tie(Tie tie, double chance) {
  chance_[tie.chosen] = std::min(chance_[tie.chosen], chance);
  if (1.0 - chance > rules_.tie_chance && !are_tied(tie.chosen, tie.rival)) {
    ties_.push_back(std::move(tie));
  }
}

void Selection::tie_inseparable() {
  std::vector<Model::Effect> set;
  for (std::size_t i = 0; i < chosen_.effects.size(); ++i) {
    set.push_back({chosen_.effects[i], pooled(chosen_, i).fitted});
  }
  for (const MemberVisibility& member : member_visibilities(bench_, set, expected_(base_), rules_, for_each_)) {
    const plant::EffectId effect = member.beside.id;
    for (const LikeEffect& rival : member.beside.rivals) {
      if (!are_tied(effect, rival.id)) {
        ties_.push_back({effect, rival.id, bench_.exchanged(chosen_, effect, rival.id, {rival.fitted, rival.fitted})});
      }
    }
  }
}

Selection::Exchange Selection::compare(plant::EffectId effect, plant::EffectId rival, const Hypothesis& other) {
  const Estimate estimate = pooled(other, other.effects.size() - 1);
  if (at_bound(rival, estimate) || !outside_neutral(rival, estimate)) {
    return Exchange::kNo;
  }
  const Hypothesis was = chosen_;
  const bool better = bench_.gain(was, other).low > 0.0;
  choose(bench_.refined(other));
  prune();
  if (better || (chosen_.effects.size() < was.effects.size() && score(chosen_) > score(was))) {
    return Exchange::kBetter;
  }
  choose(was);
  const double chance = chance_of(was, other);
  const bool simpler = channel_count(rival) < channel_count(effect) && bench_.gain(other, was).low <= 0.0;
  if (chance < 0.5 || (simpler && 1.0 - chance > rules_.tie_chance)) {
    choose(other);
    runner_up_[rival] = 1.0;
    note_tie({rival, effect, was}, std::max(chance, 1.0 - chance));
    return Exchange::kAlike;
  }
  note_tie({effect, rival, other}, chance);
  return Exchange::kNo;
}

void Selection::exchange() {
  std::vector<plant::EffectId> compared;
  const auto next = [&] {
    return std::ranges::find_if(chosen_.effects, [&](auto id) { return std::ranges::count(compared, id) == 0; });
  };
  for (auto at = next(); at != chosen_.effects.end(); at = next()) {
    const plant::EffectId effect = *at;
    compared.push_back(effect);
    for (const auto& [rival, other] : rivals_of(effect)) {
      const Exchange exchange = compare(effect, rival, other);
      if (exchange == Exchange::kBetter) {
        generalise();
        compared.clear();
        ties_.clear();
        chance_.fill(1.0);
        break;
      }
      if (exchange == Exchange::kAlike) {
        compared.push_back(rival);
        break;
      }
    }
  }
  prune();
  forget_ties();
}

void Selection::remove(plant::EffectId effect) {
  choose(Hypothesis(without(effect)));
  forget_ties();
}

void Selection::forget_ties() {
  std::erase_if(ties_, [this](const Tie& tie) { return !holds(chosen_, tie.chosen); });
}

void Selection::prune() {
  specialise();
  for (std::size_t i = 0; chosen_.effects.size() > 1 && i < chosen_.effects.size();) {
    const plant::EffectId id = chosen_.effects[i];
    if (is_needed(i)) {
      ++i;
    } else {
      choose(Hypothesis(without(id)));
      i = 0;
    }
  }
}

double Selection::share_of(plant::EffectId effect) {
  if (chosen_.effects.size() < 2) {
    return 1.0;
  }
  return gain_of(effect) / std::max(bench_.gain(base_, chosen_).log_ratio, 1e-12);
}

double Selection::gain_of(plant::EffectId effect) {
  return bench_.gain(chosen_.effects.size() < 2 ? base_ : without(effect), chosen_).log_ratio;
}

}  // namespace farrier::diagnosis
