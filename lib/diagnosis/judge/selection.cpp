#include "diagnosis/judge/selection.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "diagnosis/judge/screening.hpp"

namespace farrier::diagnosis {
namespace {

/// True if a fit ended at the limit of a parameter: the effect then models something else.
bool at_bound(plant::EffectId id, const Estimate& estimate) {
  const plant::Parameter& first = plant::effect_info(id).parameters[0];
  const double margin = 0.01 * (first.high - first.low);
  return estimate.fitted[0] > first.high - margin || (first.low < 0.0 && estimate.fitted[0] < first.low + margin);
}

/// True if two effects show on one channel: only then may one stand for the other.
bool may_be_rivals(plant::EffectId one, plant::EffectId other) { return meet(channels_of(one), channels_of(other)); }

std::ptrdiff_t channel_count(plant::EffectId id) { return std::ranges::count(channels_of(id), true); }

bool holds(const Hypothesis& hypothesis, plant::EffectId id) {
  return std::ranges::find(hypothesis.effects, id) != hypothesis.effects.end();
}

}  // namespace

Estimate pooled(const Hypothesis& hypothesis, std::size_t index) {
  const auto number = [&](std::size_t half) -> const std::vector<double>& {
    return hypothesis.halves[half].model.effects[index].fitted;
  };
  std::size_t place = 0;
  for (std::size_t i = 0; i < index; ++i) {
    place += hypothesis.halves[0].model.effects[i].fitted.size();
  }
  Estimate estimate{number(0), 0.0};
  for (std::size_t i = 0; i < estimate.fitted.size(); ++i) {
    estimate.fitted[i] = 0.5 * (number(0)[i] + number(1)[i]);
  }
  const double a = hypothesis.halves[0].deviation[place];
  const double b = hypothesis.halves[1].deviation[place];
  estimate.deviation = std::max(0.5 * std::sqrt(a * a + b * b), 0.5 * std::abs(number(0)[0] - number(1)[0]));
  return estimate;
}

Selection::Selection(const Bench& bench, const ExpectedResiduals& expected, const Rules& rules, const ForEach& for_each)
    : bench_(bench),
      expected_(expected),
      rules_(rules),
      for_each_(for_each),
      base_(bench.base()),
      chosen_(base_),
      before_(remainder(bench, base_, expected)) {
  confidence_.fill(1.0);
}

ChannelMask Selection::open_channels() const {
  const auto left = remainder(bench_, chosen_, expected_);
  ChannelMask open{};
  for (std::size_t c = 0; c < kChannels; ++c) {
    open[c] = bench_.fit_data().judged[c] && left[c].rms > rules_.open_ratio * left[c].expected &&
              left[c].rms > rules_.further_step * before_[c].rms && left[c].nrmse > 0.5 * rules_.least_nrmse;
  }
  return open;
}

double Selection::score(const Hypothesis& hypothesis) const {
  return bench_.gain(base_, hypothesis).log_ratio -
         rules_.price_of_effect * static_cast<double>(hypothesis.effects.size());
}

void Selection::grow() {
  ChannelMask open = chosen_.effects.empty() ? bench_.fit_data().judged : open_channels();
  for (std::size_t round = 0; round < 2 * rules_.most_effects && meet(open, open) && add(open); ++round) {
    prune();
    open = open_channels();
  }
}

void Selection::grow_from_others() {
  const ChannelMask open = open_channels();
  if (chosen_.effects.size() < 2 && !meet(open, open)) {
    return;
  }
  std::size_t grown = 0;
  for (std::size_t i = 1; i < first_.size() && grown < rules_.most_regrown; ++i) {
    const Hypothesis best = chosen_;
    if (holds(best, first_[i].effects.front())) {
      continue;
    }
    ++grown;
    const auto confidence = confidence_;
    const auto rivals = rivals_;
    const auto rounds = rounds_;
    confidence_.fill(1.0);
    rivals_.clear();
    rounds_.resize(1);
    choose(first_[i]);
    grow();
    if (score(chosen_) <= score(best)) {
      choose(best);
      confidence_ = confidence;
      rivals_ = rivals;
      rounds_ = rounds;
    }
  }
}

bool Selection::outside_neutral(plant::EffectId id, const Estimate& estimate) const {
  const Simulator& simulator = bench_.simulator();
  const plant::EffectInfo& info = plant::effect_info(id);
  const std::vector<double>* known = simulator.known(id);
  const double neutral = known != nullptr ? (*known)[0] : simulator.scales().neutral(info.parameters[0]);
  const double nominal = info.nominal || known != nullptr ? kNominalBand * std::abs(neutral) : 0.0;
  const double band = std::max(nominal, simulator.least(id));
  return std::abs(estimate.fitted[0] - neutral) > band + rules_.neutral_deviations * estimate.deviation;
}

/// True if a hypothesis sufficiently reduces the chosen one's remainder on some channel.
bool Selection::worth_it(const Hypothesis& after) const {
  for (std::size_t c = 0; c < kChannels; ++c) {
    const double was = chosen_.total(c);
    const double is = after.total(c);
    const double share = chosen_.effects.empty() ? rules_.least_step : rules_.further_step;
    const double step = share * share * base_.total(c);
    const double ratio = 1.0 - rules_.least_reduction;
    if (was > 0.0 && is < ratio * ratio * was && was - is > step) {
      return true;
    }
  }
  return false;
}

std::vector<plant::EffectId> Selection::promising(const std::vector<Screening::Promise>& promises,
                                                  const ChannelMask& open) const {
  const double least = rules_.least_promise * rules_.least_reduction;
  std::vector<plant::EffectId> all;
  for (plant::EffectId id = 0; id < plant::kEffectCount; ++id) {
    if (!promises[id].start.empty() && promises[id].log_ratio > least) {
      all.push_back(id);
    }
  }
  std::ranges::sort(all, std::greater{}, [&](plant::EffectId id) { return promises[id].log_ratio; });
  std::vector<plant::EffectId> kept;
  std::array<std::size_t, kChannels> on_channel{};
  for (const plant::EffectId id : all) {
    const ChannelMask shows = channels_of(id);
    bool wanted = false;
    for (std::size_t c = 0; c < kChannels; ++c) {
      wanted = wanted || (shows[c] && open[c] && on_channel[c]++ < rules_.most_fitted);
    }
    if (wanted) {
      kept.push_back(id);
    }
  }
  return kept;
}

std::vector<Selection::Tried> Selection::try_all(const ChannelMask& open) const {
  std::vector<Tried> tried(plant::kEffectCount);
  const Screening screening(bench_, chosen_);
  std::vector<Screening::Promise> promises(plant::kEffectCount);
  for_each_(plant::kEffectCount, [&](std::size_t id) {
    if (meet(channels_of(id), open) && !holds(chosen_, id)) {
      promises[id] = screening.promise_of(id);
    }
  });
  const std::vector<plant::EffectId> ids = promising(promises, open);
  std::vector<std::optional<Bench::Sketch>> sketches(ids.size());
  for_each_(ids.size(), [&](std::size_t i) { sketches[i] = bench_.sketch(chosen_, ids[i], {promises[ids[i]].start}); });
  double best = 0.0;
  for (const auto& sketch : sketches) {
    best = std::max(best, sketch ? sketch->promise : 0.0);
  }
  const double least = std::max(0.5 * rules_.least_reduction, rules_.near_best * best);
  for_each_(ids.size(), [&](std::size_t i) {
    if (!sketches[i] || sketches[i]->promise < least) {
      return;
    }
    const plant::EffectId id = ids[i];
    Tried& one = tried[id];
    one.hypothesis = bench_.with(chosen_, *sketches[i], 0.5 * rules_.least_reduction);
    if (one.hypothesis) {
      const Hypothesis& with = *one.hypothesis;
      one.gain = bench_.gain(chosen_, with);
      one.estimate = pooled(with, with.effects.size() - 1);
      one.accepted = !at_bound(id, one.estimate) && one.gain.low > 0.0 && one.gain.by_half[0] > 0.0 &&
                     one.gain.by_half[1] > 0.0 && worth_it(with) && outside_neutral(id, one.estimate);
    }
  });
  return tried;
}

bool Selection::add(const ChannelMask& open) {
  if (chosen_.effects.size() >= rules_.most_effects) {
    return false;
  }
  std::vector<Tried> tried = try_all(open);
  std::vector<Candidate> lines;
  plant::EffectId best = plant::kEffectCount;
  for (plant::EffectId id = 0; id < plant::kEffectCount; ++id) {
    const Tried& one = tried[id];
    if (!one.hypothesis) {
      continue;
    }
    lines.push_back({id, one.gain, one.estimate.fitted[0], one.estimate.deviation, one.accepted});
    if (one.accepted && (best == plant::kEffectCount || one.gain.log_ratio > tried[best].gain.log_ratio)) {
      best = id;
    }
  }
  rounds_.push_back(std::move(lines));
  if (chosen_.effects.empty()) {
    for (Tried& one : tried) {
      if (one.accepted) {
        first_.push_back(*one.hypothesis);
      }
    }
    std::ranges::sort(first_, std::greater{}, [&](const Hypothesis& h) { return score(h); });
  }
  if (best == plant::kEffectCount) {
    return false;
  }
  note_rivals(tried, best);
  choose(std::move(*tried[best].hypothesis));
  return true;
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
  for (plant::EffectId id = 0; id < plant::kEffectCount; ++id) {
    if (id == best || !tried[id].accepted || !may_be_rivals(id, best)) {
      continue;
    }
    const double chance = chance_of(*tried[best].hypothesis, *tried[id].hypothesis);
    if (1.0 - chance > rules_.tie_chance) {
      const auto& halves = tried[id].hypothesis->halves;
      rivals_.push_back({best, id, {halves[0].model.effects.back().fitted, halves[1].model.effects.back().fitted}});
    } else {
      confidence_[best] = std::min(confidence_[best], chance);
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
  return outside_neutral(chosen_.effects[index], pooled(chosen_, index)) && gain.low > 0.0 &&
         *std::ranges::max_element(gain.reduction) > 0.5 * rules_.least_reduction;
}

void Selection::exchange() {
  for (std::size_t i = 0; i < chosen_.effects.size();) {
    const plant::EffectId was = chosen_.effects[i];
    const Hypothesis less = without(was);
    const double mine = bench_.gain(less, chosen_).log_ratio;
    const Screening screening(bench_, less);
    std::vector<Screening::Promise> promises(plant::kEffectCount);
    for_each_(plant::kEffectCount, [&](std::size_t id) {
      if (may_be_rivals(id, was) && !holds(chosen_, id)) {
        promises[id] = screening.promise_of(id);
      }
    });
    const auto best = std::ranges::max_element(promises, {}, &Screening::Promise::log_ratio);
    const auto id = static_cast<plant::EffectId>(best - promises.begin());
    if (best->start.empty() || best->log_ratio < rules_.least_exchange * mine) {
      ++i;
      continue;
    }
    const auto sketch = bench_.sketch(less, id, {best->start});
    auto other = sketch ? bench_.with(less, *sketch, 0.5 * rules_.least_reduction) : std::optional<Hypothesis>();
    if (other && bench_.gain(chosen_, *other).low > 0.0 && !at_bound(id, pooled(*other, other->effects.size() - 1)) &&
        outside_neutral(id, pooled(*other, other->effects.size() - 1))) {
      choose(std::move(*other));
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
  return bench_.gain(without(effect), chosen_).log_ratio / std::max(bench_.gain(base_, chosen_).log_ratio, 1e-12);
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
      std::erase_if(ties_, [&](const Tie& earlier) { return earlier.chosen == tie.rival; });
      chance = std::max(chance, 1.0 - chance);
    }
    confidence_[tie.chosen] = std::min(confidence_[tie.chosen], chance);
    if (1.0 - chance > rules_.tie_chance) {
      ties_.push_back(std::move(tie));
    }
  }
}

}  // namespace farrier::diagnosis
