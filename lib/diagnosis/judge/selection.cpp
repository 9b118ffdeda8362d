#include "diagnosis/judge/selection.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "diagnosis/judge/screening.hpp"
#include "plant/terms/load_effects.hpp"

namespace farrier::diagnosis {
namespace {

/// Difference of scores of a set's fits that go on from different ones.
constexpr double kSameScore = 1e-3;

}  // namespace

bool at_bound(plant::EffectId id, const Estimate& estimate) {
  const plant::Parameter& first = plant::effect_info(id).parameters[0];
  const double margin = 0.01 * (first.high - first.low);
  return estimate.fitted[0] > first.high - margin || (first.low < 0.0 && estimate.fitted[0] < first.low + margin);
}

bool holds(const Hypothesis& hypothesis, plant::EffectId id) {
  return std::ranges::find(hypothesis.effects, id) != hypothesis.effects.end();
}

Estimate pooled(const Hypothesis& hypothesis, std::size_t index) {
  const auto number = [&](std::size_t half) -> const std::vector<double>& {
    return hypothesis.halves[half].model.effects[index].fitted;
  };
  std::size_t place = 0;
  for (std::size_t i = 0; i < index; ++i) {
    place += hypothesis.halves[0].model.effects[i].fitted.size();
  }
  Estimate estimate{number(0), 0.0, std::abs(number(0)[0] - number(1)[0])};
  for (std::size_t i = 0; i < estimate.fitted.size(); ++i) {
    estimate.fitted[i] = 0.5 * (number(0)[i] + number(1)[i]);
  }
  const double a = hypothesis.halves[0].deviation[place];
  const double b = hypothesis.halves[1].deviation[place];
  estimate.deviation = std::max(0.5 * std::sqrt(a * a + b * b), 0.5 * estimate.halves_apart);
  return estimate;
}

double neutral_value(const Simulator& simulator, plant::EffectId id) {
  const std::vector<double>* const known = simulator.known(id);
  return known != nullptr ? (*known)[0] : simulator.scales().neutral(plant::effect_info(id).parameters[0]);
}

double neutral_band(const Simulator& simulator, plant::EffectId id, const Rules& rules) {
  const bool nominal = plant::effect_info(id).nominal || simulator.known(id) != nullptr;
  const double share = plant::is_in_load(id) ? rules.load_band : kNominalBand;
  return std::max(nominal ? share * std::abs(neutral_value(simulator, id)) : 0.0, simulator.least(id));
}

Selection::Selection(const Bench& bench, const ExpectedResiduals& expected, const Rules& rules, const ForEach& for_each)
    : bench_(bench),
      expected_(expected),
      rules_(rules),
      for_each_(for_each),
      base_(bench.base()),
      chosen_(base_),
      before_(remainder(bench, base_, expected)),
      above_noise_(channels_above_noise()) {
  chance_.fill(1.0);
}

ChannelMask Selection::channels_above_noise() const {
  ChannelMask above{};
  for (std::size_t c = 0; c < kChannels; ++c) {
    above[c] = bench_.fit_data().judged[c] && (1.0 - rules_.least_reduction) * before_[c].rms > before_[c].expected;
  }
  return above;
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
  ChannelMask open = chosen_.effects.empty() ? above_noise_ : open_channels();
  for (std::size_t round = 0; round < 2 * rules_.most_effects && meet(open, open); ++round) {
    if (reached_before() || (!generalise() && !add(open))) {
      return;
    }
    prune();
    open = open_channels();
  }
}

bool Selection::reached_before() {
  std::vector<plant::EffectId> set = chosen_.effects;
  std::ranges::sort(set);
  const double now = score(chosen_);
  const auto [known, is_new] = reached_.try_emplace(std::move(set), now);
  const double was = std::exchange(known->second, std::max(known->second, now));
  return !is_new && now < was + kSameScore;
}

void Selection::grow_from_others() {
  const auto explains_all = [this] {
    const ChannelMask open = open_channels();
    return !meet(open, open);
  };
  // One effect that left nothing to explain would have been the best at first, so two that do are as few as can be.
  if (chosen_.effects.size() < 3 && explains_all()) {
    return;
  }
  std::size_t grown = 0;
  for (std::size_t i = 1; i < first_.size() && grown < rules_.most_regrown; ++i) {
    if (!holds(chosen_, first_[i].effects.front())) {
      ++grown;
      try_growing_from(first_[i]);
    }
  }
  for (const Hypothesis& first : first_of_channel_) {
    const plant::EffectId id = first.effects.back();
    if (meet(open_channels(), bench_.simulator().channels(id)) && !holds(chosen_, id)) {
      try_growing_from(first);
    }
  }
}

void Selection::try_growing_from(const Hypothesis& first) {
  const Hypothesis best = chosen_;
  const auto rounds = rounds_;
  rounds_.resize(1);
  choose(bench_.refined(first));
  prune();
  regrows_ = true;
  grow();
  if (score(chosen_) <= score(best)) {
    choose(best);
    rounds_ = rounds;
  }
}

bool Selection::outside_neutral(plant::EffectId id, const Estimate& estimate) const {
  const double distance = std::abs(estimate.fitted[0] - neutral_value(bench_.simulator(), id));
  return distance > neutral_band(bench_.simulator(), id, rules_) + rules_.neutral_deviations * estimate.deviation;
}

/// True if a hypothesis sufficiently reduces the chosen one's remainder on some channel where that is more than noise.
bool Selection::worth_it(const Hypothesis& after) const {
  for (std::size_t c = 0; c < kChannels; ++c) {
    const double was = chosen_.total(c);
    const double is = after.total(c);
    const double share = chosen_.effects.empty() ? rules_.least_step : rules_.further_step;
    const double step = share * share * base_.total(c);
    const double ratio = 1.0 - rules_.least_reduction;
    if (above_noise_[c] && is < ratio * ratio * was && was - is > step) {
      return true;
    }
  }
  return false;
}

std::vector<plant::EffectId> Selection::promising(const std::vector<Screening::Promise>& promises,
                                                  const ChannelMask& open) const {
  const double least = rules_.least_promise * rules_.least_reduction;
  std::vector<plant::EffectId> all;
  for (plant::EffectId id = 0; id < plant::kNameableCount; ++id) {
    if (!promises[id].start.empty() && (!rules_.screens || promises[id].log_ratio > least)) {
      all.push_back(id);
    }
  }
  std::ranges::sort(all, std::greater{}, [&](plant::EffectId id) { return promises[id].log_ratio; });
  std::vector<plant::EffectId> kept;
  std::array<std::size_t, kChannels> on_channel{};
  for (const plant::EffectId id : all) {
    const ChannelMask shows = bench_.simulator().channels(id);
    bool wanted = false;
    for (std::size_t c = 0; c < kChannels; ++c) {
      // A general form takes no place of another effect.
      const bool has_place = !rules_.screens || plant::is_general_form(id) || on_channel[c]++ < rules_.most_fitted;
      wanted = wanted || (shows[c] && open[c] && has_place);
    }
    if (wanted) {
      kept.push_back(id);
    }
  }
  return kept;
}

std::vector<Selection::Tried> Selection::try_all(const ChannelMask& open) const {
  std::vector<Tried> tried(plant::kNameableCount);
  const Screening screening(bench_, chosen_);
  std::vector<Screening::Promise> promises(plant::kNameableCount);
  for_each_(plant::kNameableCount, [&](std::size_t id) {
    if (meet(bench_.simulator().channels(id), open) && (may_be_added(chosen_, id) || may_be_added_as_general(id))) {
      promises[id] = screening.promise_of(id);
    }
  });
  const std::vector<plant::EffectId> ids = promising(promises, open);
  std::vector<std::optional<Bench::Sketch>> sketches(ids.size());
  for_each_(ids.size(), [&](std::size_t i) {
    const plant::EffectId id = ids[i];
    const std::vector<std::vector<double>> screened{promises[id].start};
    sketches[i] = bench_.sketch(chosen_, id, rules_.screens ? screened : bench_.simulator().starts(id));
  });
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
  for (plant::EffectId id = 0; id < plant::kNameableCount; ++id) {
    if (tried[id].accepted && plant::is_general_form(id)) {
      const auto& special = tried[plant::special_case_of(id)].hypothesis;
      tried[id].accepted = explains_more_than_special(id, special.value_or(chosen_), *tried[id].hypothesis);
    }
  }
  return tried;
}

bool Selection::add(const ChannelMask& open) {
  if (chosen_.effects.size() >= rules_.most_effects) {
    return false;
  }
  std::vector<Tried> tried = try_all(open);
  std::vector<Candidate> lines;
  plant::EffectId best = plant::kNameableCount;
  for (plant::EffectId id = 0; id < plant::kNameableCount; ++id) {
    const Tried& one = tried[id];
    if (!one.hypothesis) {
      continue;
    }
    lines.push_back({id, one.gain, one.estimate.fitted[0], one.estimate.deviation, one.accepted});
    if (one.accepted && (best == plant::kNameableCount || one.gain.log_ratio > tried[best].gain.log_ratio)) {
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
  } else if (!regrows_) {
    for (plant::EffectId id = 0; id < plant::kNameableCount; ++id) {
      const bool is_first = std::ranges::none_of(chosen_.effects, [&](auto other) { return may_be_rivals(id, other); });
      if (tried[id].accepted && id != best && is_first) {
        first_of_channel_.push_back(*tried[id].hypothesis);
      }
    }
  }
  if (best == plant::kNameableCount) {
    return add_once(open);
  }
  note_rivals(tried, best);
  choose(bench_.refined(*tried[best].hypothesis));
  return true;
}

}  // namespace farrier::diagnosis
