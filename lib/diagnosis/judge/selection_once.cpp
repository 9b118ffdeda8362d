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

bool Selection::explains_once(const Hypothesis& with, std::size_t half, const ChannelMask& shows) const {
  const std::size_t other = 1 - half;
  const auto expected = expected_(with);
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (!shows[c] || !bench_.fit_data().judged[c]) {
      continue;
    }
    const double idle = bench_.fitted_square(with, other, c);
    const bool acts = std::abs(idle - chosen_.fitted_squares[c][other]) > kSame * chosen_.fitted_squares[c][other];
    const double left = bench_.rms_of_half(with.fitted_squares[c][half], half, c);
    const double was = bench_.rms_of_half(chosen_.fitted_squares[c][half], half, c);
    if (acts || left > std::max(rules_.structure_ratio * expected[c], rules_.unexplained * was)) {
      return false;
    }
  }
  return true;
}

bool Selection::add_once(const ChannelMask& open) {
  const std::optional<std::size_t> half = eventful_half(open);
  if (!half) {
    return false;
  }
  std::vector<Tried> tried(plant::kNameableCount);
  for_each_(plant::kNameableCount, [&](std::size_t id) {
    const ChannelMask shows = bench_.simulator().channels(id);
    if (!meet(shows, open) || holds(chosen_, id)) {
      return;
    }
    Tried& one = tried[id];
    one.hypothesis = bench_.with_in_half(chosen_, id, *half);
    if (one.hypothesis) {
      one.gain = bench_.gain(chosen_, *one.hypothesis);
      one.estimate = pooled(*one.hypothesis, one.hypothesis->effects.size() - 1);
      one.accepted = !at_bound(id, one.estimate) && outside_neutral(id, one.estimate) && worth_it(*one.hypothesis) &&
                     explains_once(*one.hypothesis, *half, shows);
    }
  });
  const auto best = std::ranges::max_element(tried, {}, [](const Tried& one) {
    return one.accepted ? one.gain.log_ratio : -std::numeric_limits<double>::infinity();
  });
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

}  // namespace farrier::diagnosis
