#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "diagnosis/judge/selection.hpp"

namespace farrier::diagnosis {
namespace {

/// Pairs that are fitted, and of these the ones with the same effect.
constexpr std::size_t kMostPairs = 6;
constexpr std::size_t kMostWithEffect = 2;
/// Pairs from which a set is grown in place of the chosen effects of a channel.
constexpr std::size_t kMostGrown = 2;

/// The most promising pairs, no effect in more than kMostWithEffect of them.
std::vector<Screening::PairPromise> most_promising(std::vector<Screening::PairPromise> pairs, double least) {
  std::ranges::stable_sort(pairs, std::greater{}, &Screening::PairPromise::log_ratio);
  std::array<std::size_t, plant::kNameableCount> taken{};
  std::vector<Screening::PairPromise> best;
  for (Screening::PairPromise& pair : pairs) {
    if (best.size() == kMostPairs || pair.start.empty() || pair.log_ratio < least) {
      break;
    }
    if (taken[pair.start[0].id] < kMostWithEffect && taken[pair.start[1].id] < kMostWithEffect) {
      ++taken[pair.start[0].id];
      ++taken[pair.start[1].id];
      best.push_back(std::move(pair));
    }
  }
  return best;
}

}  // namespace

std::vector<Screening::PairPromise> Selection::pair_promises(const Hypothesis& from, const ChannelMask& open) const {
  std::vector<std::pair<plant::EffectId, plant::EffectId>> ids;
  for (plant::EffectId one = 0; one < plant::kNameableCount; ++one) {
    for (plant::EffectId other = one + 1; other < plant::kNameableCount; ++other) {
      const ChannelMask both = both_of(bench_.simulator().channels(one), bench_.simulator().channels(other));
      if (meet(both, open) && may_be_added(chosen_, one) && may_be_added(chosen_, other)) {
        ids.emplace_back(one, other);
      }
    }
  }
  const Screening screening(bench_, from);
  std::vector<Screening::PairPromise> promises(ids.size());
  for_each_(ids.size(), [&](std::size_t i) { promises[i] = screening.promise_of(ids[i].first, ids[i].second); });
  return promises;
}

bool Selection::explains_as_pair(const Hypothesis& from, const Hypothesis& with) const {
  const Gain gain = bench_.gain(from, with);
  if (gain.low <= 0.0 || gain.by_half[0] <= 0.0 || gain.by_half[1] <= 0.0) {
    return false;
  }
  for (std::size_t i = with.effects.size() - 2; i < with.effects.size(); ++i) {
    const Estimate estimate = pooled(with, i);
    if (at_bound(with.effects[i], estimate) || !outside_neutral(with.effects[i], estimate) ||
        !adds_to(bench_.without(with, with.effects[i]), with)) {
      return false;
    }
  }
  return true;
}

std::vector<Hypothesis> Selection::pairs_beside(const Hypothesis& from, const ChannelMask& open) const {
  if (from.effects.size() + 2 > rules_.most_effects) {
    return {};
  }
  const double least = rules_.least_promise * rules_.least_reduction;
  const std::vector<Screening::PairPromise> promises = most_promising(pair_promises(from, open), least);
  std::vector<std::optional<Hypothesis>> fitted(promises.size());
  for_each_(promises.size(), [&](std::size_t i) {
    fitted[i] = bench_.with(from, bench_.sketch(from, promises[i].start), 0.5 * rules_.least_reduction);
    if (fitted[i] && !explains_as_pair(from, *fitted[i])) {
      fitted[i].reset();
    }
  });
  std::vector<Hypothesis> pairs;
  for (std::optional<Hypothesis>& one : fitted) {
    if (one) {
      pairs.push_back(std::move(*one));
    }
  }
  std::ranges::stable_sort(pairs, std::greater{}, [this](const Hypothesis& pair) { return score(pair); });
  return pairs;
}

Hypothesis Selection::without_those_of(const ChannelMask& mask) const {
  Hypothesis less = chosen_;
  for (const plant::EffectId id : chosen_.effects) {
    if (meet(bench_.simulator().channels(id), mask)) {
      less = bench_.without(less, id);
    }
  }
  return less;
}

void Selection::grow_from_wider() {
  for (std::size_t c = 0; c < kChannels; ++c) {
    ChannelMask one{};
    one[c] = true;
    const Hypothesis less = without_those_of(one);
    if (less.effects.size() + 2 > chosen_.effects.size()) {
      continue;
    }
    const Screening screening(bench_, less);
    std::vector<std::optional<Hypothesis>> wider(plant::kNameableCount);
    for_each_(plant::kNameableCount, [&](std::size_t id) {
      if (!bench_.simulator().channels(id)[c] || channel_count(id) < 2 || !may_be_added(chosen_, id)) {
        return;
      }
      if (const Screening::Promise promise = screening.promise_of(id); !promise.start.empty()) {
        wider[id] = bench_.with(less, bench_.sketch(less, {{id, promise.start}}), rules_.least_reduction);
      }
    });
    for (const std::optional<Hypothesis>& set : wider) {
      if (set) {
        try_growing_from(*set);
      }
    }
  }
}

void Selection::grow_from_pairs() {
  ChannelMask open = open_channels();
  if (!meet(open, open)) {
    return;
  }
  if (const std::vector<Hypothesis> beside = pairs_beside(chosen_, open); !beside.empty()) {
    try_growing_from(beside.front());
    open = open_channels();
  }
  const Hypothesis less = without_those_of(open);
  if (less.effects.size() == chosen_.effects.size()) {
    return;
  }
  const std::vector<Hypothesis> instead = pairs_beside(less, open);
  for (std::size_t i = 0; i < std::min(instead.size(), kMostGrown); ++i) {
    try_growing_from(instead[i]);
  }
}

}  // namespace farrier::diagnosis
