#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/judge/selection.hpp"

namespace farrier::diagnosis {
namespace {

/// Share of a channel's error in one half of the recording, from which an effect may have shown in that half alone.
constexpr double kInOneHalf = 0.8;
/// Change of the other half's error that counts as none.
constexpr double kSame = 0.05;

double sum_of(const std::vector<double>& squares, std::size_t begin, std::size_t end) {
  double sum = 0.0;
  for (std::size_t i = begin; i < std::min(end, squares.size()); ++i) {
    sum += squares[i];
  }
  return sum;
}

}  // namespace

std::optional<std::size_t> Selection::eventful_half(const ChannelMask& open) const {
  for (std::size_t c = 0; c < kChannels; ++c) {
    const std::vector<double>& squares = chosen_.squares[c];
    const double all = sum_of(squares, 0, squares.size());
    for (std::size_t half = 0; open[c] && half < 2; ++half) {
      const std::size_t middle = squares.size() / 2;
      const double mine = sum_of(squares, half * middle, half == 0 ? middle : squares.size());
      if (mine > kInOneHalf * all) {
        return half;
      }
    }
  }
  return std::nullopt;
}

bool Selection::acts_only_in(std::size_t half, const Hypothesis& without, const Hypothesis& with) const {
  const ChannelMask shows = bench_.simulator().channels(with.effects.back());
  for (std::size_t c = 0; c < kChannels; ++c) {
    const double was = without.fitted_squares[c][1 - half];
    if (shows[c] && bench_.fit_data().judged[c] && std::abs(with.fitted_squares[c][1 - half] - was) > kSame * was) {
      return false;
    }
  }
  return true;
}

bool Selection::is_explained(const Hypothesis& with, std::size_t half, const ChannelMask& shows,
                             const Hypothesis& less) const {
  const auto expected = expected_(with);
  for (std::size_t c = 0; c < kChannels; ++c) {
    const double left = bench_.rms_of_half(with.fitted_squares[c][half], half, c);
    const double was = bench_.rms_of_half(less.fitted_squares[c][half], half, c);
    if (shows[c] && bench_.fit_data().judged[c] &&
        left > std::max(rules_.structure_ratio * expected[c], rules_.unexplained * was)) {
      return false;
    }
  }
  return true;
}

std::vector<Selection::Tried> Selection::try_once(const Hypothesis& from, std::size_t half,
                                                  const ChannelMask& open) const {
  std::vector<Tried> tried(plant::kNameableCount);
  for_each_(plant::kNameableCount, [&](std::size_t id) {
    if (!meet(bench_.simulator().channels(id), open) || !may_be_added(from, id)) {
      return;
    }
    Tried& one = tried[id];
    one.hypothesis = bench_.with_in_half(from, id, half);
    if (one.hypothesis) {
      one.gain = bench_.gain(from, *one.hypothesis);
      one.estimate = pooled(*one.hypothesis, one.hypothesis->effects.size() - 1);
      one.accepted =
          !at_bound(id, one.estimate) && outside_neutral(id, one.estimate) && acts_only_in(half, from, *one.hypothesis);
    }
  });
  return tried;
}

std::vector<Selection::Tried>::iterator Selection::best_of(std::vector<Tried>& tried) {
  return std::ranges::max_element(tried, {}, [](const Tried& one) {
    return one.accepted ? one.gain.log_ratio : -std::numeric_limits<double>::infinity();
  });
}

bool Selection::add_once(const ChannelMask& open) {
  const std::optional<std::size_t> half = eventful_half(open);
  if (!half) {
    return false;
  }
  std::vector<Tried> tried = try_once(chosen_, *half, open);
  for (plant::EffectId id = 0; id < plant::kNameableCount; ++id) {
    Tried& one = tried[id];
    one.accepted = one.accepted && worth_it(*one.hypothesis) &&
                   is_explained(*one.hypothesis, *half, bench_.simulator().channels(id), chosen_);
  }
  const auto best = best_of(tried);
  if (!best->accepted) {
    return false;
  }
  const auto id = static_cast<plant::EffectId>(best - tried.begin());
  rounds_.push_back({{id, best->gain, best->estimate.fitted[0], best->estimate.deviation, true}});
  once_.push_back(id);
  note_rivals(tried, id);
  choose(bench_.refined(*best->hypothesis));
  return true;
}

void Selection::grow_from_events() {
  for (std::size_t half = 0; half < 2; ++half) {
    const ChannelMask open = open_channels();
    if (!meet(open, open)) {
      return;
    }
    const Hypothesis less = without_those_of(open);
    if (less.effects.size() + 1 > rules_.most_effects) {
      return;
    }
    std::vector<Tried> tried = try_once(less, half, open);
    for (Tried& one : tried) {
      one.accepted = one.accepted && adds_to(less, *one.hypothesis, true);
    }
    const auto best = best_of(tried);
    if (!best->accepted) {
      continue;
    }
    const auto id = static_cast<plant::EffectId>(best - tried.begin());
    const Hypothesis before = chosen_;
    const auto rounds = rounds_;
    once_.push_back(id);
    try_growing_from(*best->hypothesis);
    if (holds(chosen_, id) && !is_explained(chosen_, half, bench_.simulator().channels(id), less)) {
      choose(before);
      rounds_ = rounds;
    }
    if (!holds(chosen_, id)) {
      std::erase(once_, id);
    }
  }
}

}  // namespace farrier::diagnosis
