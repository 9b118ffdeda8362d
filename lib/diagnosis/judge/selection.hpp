#pragma once

#include <map>
#include <vector>

#include "diagnosis/judge/judgement.hpp"

namespace farrier::diagnosis {

/// Numbers of an effect by both halves' models: their means, and a deviation of the first no smaller than half of what
/// the halves differ by.
struct Estimate {
  std::vector<double> fitted;
  double deviation;
};

/// Of the effect at `index` of a hypothesis.
Estimate pooled(const Hypothesis& hypothesis, std::size_t index);

/// Choice of effects by their gain on held-out time, step by step: one more, less, or another in its place.
class Selection {
 public:
  /// All outlive this.
  Selection(const Bench& bench, const Rules& rules, const ForEach& for_each);

  /// Tries every effect that concerns an open channel beside the chosen ones and keeps the best that is accepted. False
  /// when none is.
  bool add(const ChannelMask& open);
  /// Leaves out what turned out to be nothing beside effects that came later.
  void prune();
  /// Puts every rival, fitted anew, in the place of what it was tried beside: the better one stays. A rival that may be
  /// right by more than tie_chance is not told apart; of these two the one that shows on fewer channels stays.
  void compare_rivals();

  const Hypothesis& base() const noexcept { return base_; }
  const Hypothesis& chosen() const noexcept { return chosen_; }
  const std::vector<std::vector<Candidate>>& rounds() const noexcept { return rounds_; }

  /// A rival that is not told apart from an effect that is chosen.
  struct Tie {
    plant::EffectId chosen, rival;
    Hypothesis with_rival;  ///< the chosen hypothesis with the rival, at its end, in place of the effect
  };
  const std::vector<Tie>& ties() const noexcept { return ties_; }
  /// Share of a chosen effect in the log gain of all: what is lost without it.
  double share_of(plant::EffectId effect);
  /// Chance that the effect and none of its rivals is there.
  double confidence(plant::EffectId effect) const noexcept { return confidence_[effect]; }

 private:
  struct Tried {
    std::optional<Hypothesis> hypothesis;
    Estimate estimate;  ///< of the effect that is tried
    Gain gain{};
    bool accepted = false;
  };
  struct Rival {
    plant::EffectId chosen, rival;
    std::array<std::vector<double>, 2> fitted;  ///< of the rival, by half
  };

  /// The chosen hypothesis without one of its effects, fitted once.
  const Hypothesis& without(plant::EffectId effect);
  void choose(Hypothesis hypothesis);
  std::vector<Tried> try_all(const ChannelMask& open) const;
  bool worth_it(const Hypothesis& after) const;
  bool outside_neutral(plant::EffectId id, const Estimate& estimate) const;
  /// Chance that `one` is right and not `other`, which explains the same: how often it is better under resampled
  /// blocks, the less the smaller its lead, for small leads come from details that neither has.
  double chance_of(const Hypothesis& one, const Hypothesis& other) const;
  void note_rivals(const std::vector<Tried>& tried, plant::EffectId best);

  const Bench& bench_;
  const Rules& rules_;
  const ForEach& for_each_;
  Hypothesis base_, chosen_;
  std::map<plant::EffectId, Hypothesis> without_;  ///< by effect, of the chosen hypothesis as it is
  std::vector<std::vector<Candidate>> rounds_;
  std::vector<Rival> rivals_;
  std::vector<Tie> ties_;
  std::array<double, plant::kEffectCount> confidence_;
};

}  // namespace farrier::diagnosis
