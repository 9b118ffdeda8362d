#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnosis/judge/screening.hpp"
#include "diagnosis/judge/selection.hpp"

namespace farrier::diagnosis {

bool Selection::may_be_rivals(plant::EffectId one, plant::EffectId other) const {
  return meet(bench_.simulator().channels(one), bench_.simulator().channels(other));
}

std::ptrdiff_t Selection::channel_count(plant::EffectId id) const {
  return std::ranges::count(bench_.simulator().channels(id), true);
}

double Selection::chance_of(const Hypothesis& one, const Hypothesis& other) const {
  const Gain lead = bench_.gain(other, one);
  double clearest = 0.0;
  for (std::size_t c = 0; c < kChannels; ++c) {
    clearest = std::max(clearest, std::abs(lead.reduction[c]));
  }
  return 0.5 + (lead.chance - 0.5) * std::min(1.0, clearest / rules_.clear_lead);
}

void Selection::note_rivals(const std::vector<Tried>& tried, plant::EffectId best) {
  for (plant::EffectId id = 0; id < plant::kNameableCount; ++id) {
    if (id == best || !tried[id].accepted || !may_be_rivals(id, best)) {
      continue;
    }
    const double chance = chance_of(*tried[best].hypothesis, *tried[id].hypothesis);
    if (1.0 - chance > rules_.tie_chance) {
      const auto& halves = tried[id].hypothesis->halves;
      rivals_.push_back({best, id, {halves[0].model.effects.back().fitted, halves[1].model.effects.back().fitted}});
    } else {
      chance_[best] = std::min(chance_[best], chance);
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

bool Selection::is_needed(std::size_t index) {
  const Gain gain = bench_.gain(without(chosen_.effects[index]), chosen_);
  // Half of the resamplings may lack the one event that an effect explains.
  const bool lasting = gain.low > 0.0 || std::ranges::find(once_, chosen_.effects[index]) != once_.end();
  return outside_neutral(chosen_.effects[index], pooled(chosen_, index)) && lasting &&
         *std::ranges::max_element(gain.reduction) > 0.5 * rules_.least_reduction;
}

void Selection::exchange() {
  for (std::size_t i = 0; i < chosen_.effects.size();) {
    const plant::EffectId was = chosen_.effects[i];
    const Hypothesis less = without(was);
    const double mine = bench_.gain(less, chosen_).log_ratio;
    const Screening screening(bench_, less);
    std::vector<Screening::Promise> promises(plant::kNameableCount);
    for_each_(plant::kNameableCount, [&](std::size_t id) {
      if (may_be_rivals(id, was) && !holds(chosen_, id)) {
        promises[id] = screening.promise_of(id);
      }
    });
    const auto best = std::ranges::max_element(promises, {}, &Screening::Promise::log_ratio);
    const auto id = static_cast<plant::EffectId>(best - promises.begin());
    runner_up_[was] = best->start.empty() ? 0.0 : best->log_ratio / std::max(mine, 1e-12);
    if (best->start.empty() || best->log_ratio < rules_.least_exchange * mine) {
      ++i;
      continue;
    }
    const auto sketch = bench_.sketch(less, id, {best->start});
    auto other = sketch ? bench_.with(less, *sketch, 0.5 * rules_.least_reduction) : std::optional<Hypothesis>();
    if (other && bench_.gain(chosen_, *other).low > 0.0 && !at_bound(id, pooled(*other, other->effects.size() - 1)) &&
        outside_neutral(id, pooled(*other, other->effects.size() - 1))) {
      choose(bench_.refined(*other));
      prune();
      i = 0;
    } else {
      ++i;
    }
  }
}

void Selection::prune() {
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

void Selection::compare_rivals() {
  for (const Rival& pair : rivals_) {
    if (!holds(chosen_, pair.chosen) || holds(chosen_, pair.rival)) {
      continue;
    }
    Hypothesis with_rival = bench_.exchanged(chosen_, pair.chosen, pair.rival, pair.fitted);
    Tie tie{pair.chosen, pair.rival, std::move(with_rival)};
    double chance = chance_of(chosen_, tie.with_rival);
    const bool simpler = channel_count(pair.rival) < channel_count(pair.chosen);
    if (chance < 0.5 || (simpler && 1.0 - chance > rules_.tie_chance)) {
      Hypothesis better = std::exchange(tie.with_rival, chosen_);
      choose(std::move(better));
      std::swap(tie.chosen, tie.rival);
      runner_up_[tie.chosen] = 1.0;
      std::erase_if(ties_, [&](const Tie& earlier) { return earlier.chosen == tie.rival; });
      chance = std::max(chance, 1.0 - chance);
    }
    chance_[tie.chosen] = std::min(chance_[tie.chosen], chance);
    if (1.0 - chance > rules_.tie_chance) {
      ties_.push_back(std::move(tie));
    }
  }
}

}  // namespace farrier::diagnosis
