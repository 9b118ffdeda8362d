#pragma once

#include <map>
#include <optional>
#include <vector>

#include "diagnosis/judge/judgement.hpp"
#include "diagnosis/judge/screening.hpp"

namespace farrier::diagnosis {

/// Numbers of an effect by both halves' models: their means, and a deviation of the first no smaller than half of the
/// halves' difference, which is the last.
struct Estimate {
  std::vector<double> fitted;
  double deviation;
  double halves_apart;
};

/// Estimate of the effect at `index` of a hypothesis.
Estimate pooled(const Hypothesis& hypothesis, std::size_t index);

/// Where an effect's first number is without it, or as the joint's file has it.
double neutral_value(const Simulator& simulator, plant::EffectId id);

/// True if a fit ended at the limit of a parameter: the effect then models something else.
bool at_bound(plant::EffectId id, const Estimate& estimate);

/// True if a hypothesis has the effect.
bool holds(const Hypothesis& hypothesis, plant::EffectId id);

/// Choice of effects by their gain on held-out time, step by step: adds, removes or exchanges one effect.
class Selection {
 public:
  /// All outlive this.
  Selection(const Bench& bench, const ExpectedResiduals& expected, const Rules& rules, const ForEach& for_each);

  /// Adds effects while a channel is open and one is accepted; removes those that later ones made needless.
  void grow();
  /// Grows sets from the other effects that were accepted at first, too, and keeps the one that explains most. A wrong first
  /// effect may stand for two or three right ones.
  void grow_from_others();

  /// Tries every effect in the place of each chosen one, and takes those that explain more, until none does.
  void exchange();
  /// Fits every rival in the place of the effect it was tried beside and keeps the better one. A rival that may be
  /// right by more than tie_chance cannot be excluded; of these two the one that shows on fewer channels stays.
  void compare_rivals();

  const Hypothesis& base() const noexcept { return base_; }
  /// Remainders of the base.
  const std::array<Remainder, kChannels>& before() const noexcept { return before_; }
  const Hypothesis& chosen() const noexcept { return chosen_; }
  const std::vector<std::vector<Candidate>>& rounds() const noexcept { return rounds_; }

  /// A rival of a chosen effect that cannot be excluded.
  struct Tie {
    plant::EffectId chosen, rival;
    Hypothesis with_rival;  ///< the chosen hypothesis with the rival, at its end, in place of the effect
  };
  const std::vector<Tie>& ties() const noexcept { return ties_; }
  /// Share of a chosen effect in the log gain of all: the loss without it.
  double share_of(plant::EffectId effect);
  /// Log gain that is lost without a chosen effect.
  double gain_of(plant::EffectId effect);
  /// Its rivals' part of the evidence.
  Evidence evidence(plant::EffectId effect) const noexcept {
    return {.rival_chance = chance_[effect], .runner_up = runner_up_[effect]};
  }

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

  /// Tries every effect that concerns an open channel beside the chosen ones and keeps the best that is accepted.
  /// Returns false if none is, or there are most_effects.
  bool add(const ChannelMask& open);
  /// The same for an effect that shows in one half of the recording alone, as a stop that is hit once: the other half cannot
  /// confirm it. It must leave no structure where it shows, and change nothing elsewhere.
  bool add_once(const ChannelMask& open);
  /// The half that has nearly all error of an open channel, if one has.
  std::optional<std::size_t> eventful_half(const ChannelMask& open) const;
  bool explains_once(const Hypothesis& with, std::size_t half, const ChannelMask& shows) const;
  /// Removes effects that became negligible beside later ones.
  void prune();
  /// Channels on which something is left to explain.
  ChannelMask open_channels() const;
  /// Channels on which the base leaves so much more than its sensors' noise that an effect can bring least_reduction.
  ChannelMask channels_above_noise() const;
  /// Log ratio of errors that a set explains, less what each effect must bring.
  double score(const Hypothesis& hypothesis) const;
  /// The promising effects of each open channel, the most promising first.
  std::vector<plant::EffectId> promising(const std::vector<Screening::Promise>& promises,
                                         const ChannelMask& open) const;
  /// The chosen hypothesis without one of its effects, fitted once.
  const Hypothesis& without(plant::EffectId effect);
  void choose(Hypothesis hypothesis);
  std::vector<Tried> try_all(const ChannelMask& open) const;
  /// True if the chosen hypothesis is worse without the effect at `index`.
  bool is_needed(std::size_t index);
  bool worth_it(const Hypothesis& after) const;
  bool outside_neutral(plant::EffectId id, const Estimate& estimate) const;
  /// Chance that `one` is right and not `other`, which explains the same. It is the share of resampled blocks in which
  /// it is better, reduced for a small lead, since small leads come from details that neither has.
  double chance_of(const Hypothesis& one, const Hypothesis& other) const;
  /// True if two effects show on one channel: only then may one stand for the other.
  bool may_be_rivals(plant::EffectId one, plant::EffectId other) const;
  std::ptrdiff_t channel_count(plant::EffectId id) const;
  void note_rivals(const std::vector<Tried>& tried, plant::EffectId best);

  const Bench& bench_;
  const ExpectedResiduals& expected_;
  const Rules& rules_;
  const ForEach& for_each_;
  Hypothesis base_, chosen_;
  std::array<Remainder, kChannels> before_;        ///< of the base
  ChannelMask above_noise_;                        ///< where `before_` is more than noise
  std::vector<Hypothesis> first_;                  ///< accepted in the first round, the best first
  std::map<plant::EffectId, Hypothesis> without_;  ///< by effect, of the chosen hypothesis as it is
  std::vector<std::vector<Candidate>> rounds_;
  std::vector<plant::EffectId> once_;  ///< that add_once added
  std::vector<Rival> rivals_;
  std::vector<Tie> ties_;
  std::array<double, plant::kNameableCount> chance_{};     ///< that no rival of it explains more
  std::array<double, plant::kNameableCount> runner_up_{};  ///< as in Evidence
};

}  // namespace farrier::diagnosis
