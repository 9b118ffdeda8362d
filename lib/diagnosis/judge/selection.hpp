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

/// Distance from its neutral value within which an effect's first number is no effect.
double neutral_band(const Simulator& simulator, plant::EffectId id, const Rules& rules);

/// True if a fit ended at the limit of a parameter: the effect then models something else.
bool at_bound(plant::EffectId id, const Estimate& estimate);

/// True if a hypothesis has the effect.
bool holds(const Hypothesis& hypothesis, plant::EffectId id);

/// True if an effect may stand beside those of a hypothesis or in the place of one. General forms follow their special cases.
bool may_be_added(const Hypothesis& to, plant::EffectId id);

/// Choice of effects by their gain on held-out time, step by step: adds, removes or exchanges one effect.
class Selection {
 public:
  /// All outlive this.
  Selection(const Bench& bench, const ExpectedResiduals& expected, const Rules& rules, const ForEach& for_each);

  /// Adds effects while a channel is open and one is accepted; removes those that later ones made needless. Ends at a set from
  /// which an earlier growth went on.
  void grow();
  /// Grows sets from the other effects that were accepted at first, of all and on a channel, too, and keeps the one that
  /// explains most. A wrong first effect may stand for two or three right ones.
  void grow_from_others();

  /// While more than noise is left: adds two effects at once that explain it together, though neither does so alone. Grows
  /// sets from such pairs in place of the chosen ones, too, and keeps the set that explains most.
  void grow_from_pairs();

  /// While more than noise is left: grows sets from an effect that shows in one half of the recording alone, in place of the
  /// chosen ones of open channels. A stop that is hit in one half hides the effects beside it.
  void grow_from_events();

  /// Grows sets from each effect of several channels in place of all chosen ones of a channel that has two or more, and keeps
  /// the set that explains most. A gain of the load cell looks like another mass, damping and stiffness of the load, each
  /// of which explains the load better than the gain while something else is missing beside the valve.
  void grow_from_wider();

  /// Tries rivals in the place of each chosen effect until no exchange is better. A rival that explains more is taken, and
  /// one with which a further effect is needless. A rival that may be right by more than tie_chance cannot be excluded; of
  /// these two the one that shows on fewer channels stays, unless the other leads in the whole band.
  void exchange();
  /// Ties each chosen effect with those outside the set from which this recording cannot tell it, by member_visibilities(). No
  /// verdict then contradicts what was said before the fits.
  void tie_inseparable();
  /// Removes a chosen effect.
  void remove(plant::EffectId effect);

  const Hypothesis& base() const noexcept { return base_; }
  /// Remainders of the base.
  const std::array<Remainder, kChannels>& before() const noexcept { return before_; }
  const Hypothesis& chosen() const noexcept { return chosen_; }
  const std::vector<std::vector<Candidate>>& rounds() const noexcept { return rounds_; }

  /// A rival of a chosen effect that cannot be excluded.
  struct Tie {
    plant::EffectId chosen, rival;
    Hypothesis with_rival;  ///< the chosen hypothesis with the rival in place of the effect
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
  /// Result of an exchange: none, a better set, or a set that explains the same and shows on fewer channels.
  enum class Exchange { kNo, kBetter, kAlike };

  /// Tries every effect that concerns an open channel beside the chosen ones and keeps the best that is accepted.
  /// Returns false if none is, or there are most_effects.
  bool add(const ChannelMask& open);
  /// The same for an effect that shows in one half of the recording alone, as a stop that is hit once: the other half cannot
  /// confirm it. It must leave no structure where it shows, and change nothing elsewhere.
  bool add_once(const ChannelMask& open);
  /// The half that has nearly all error of an open channel, if one has.
  std::optional<std::size_t> eventful_half(const ChannelMask& open) const;
  /// Adds each effect of an open channel to `from` by its numbers in one half alone.
  std::vector<Tried> try_once(const Hypothesis& from, std::size_t half, const ChannelMask& open) const;
  /// True if the last effect of `with` changes nothing in the other half.
  bool acts_only_in(std::size_t half, const Hypothesis& without, const Hypothesis& with) const;
  /// True if no structure is left in a half on channels of `shows`, or little of what `less` left.
  bool is_explained(const Hypothesis& with, std::size_t half, const ChannelMask& shows, const Hypothesis& less) const;
  /// The accepted one that explains most; one that is not accepted if there is none.
  static std::vector<Tried>::iterator best_of(std::vector<Tried>& tried);
  /// The chosen hypothesis without its effects on channels of `mask`.
  Hypothesis without_those_of(const ChannelMask& mask) const;
  /// Every two effects of one open channel that the chosen hypothesis has not, by what a linear step beside `from` promises.
  std::vector<Screening::PairPromise> pair_promises(const Hypothesis& from, const ChannelMask& open) const;
  /// True if `with`, which has two effects more than `from`, explains more and needs both.
  bool explains_as_pair(const Hypothesis& from, const Hypothesis& with) const;
  /// True if `with` explains sufficiently more than `less` on a channel. Half of the resamplings may lack the event of an effect
  /// that shows `once`, so that their band does not count.
  bool adds_to(const Hypothesis& less, const Hypothesis& with, bool once = false) const;
  /// Pairs beside `from` that explain open channels and each of which is needed, fitted, the best first.
  std::vector<Hypothesis> pairs_beside(const Hypothesis& from, const ChannelMask& open) const;
  /// True if the chosen set was reached before with as good a fit. Notes that it is now.
  bool reached_before();
  /// Grows from a set and keeps the result if it explains more than the chosen one.
  void try_growing_from(const Hypothesis& first);
  /// An effect that may stand in the place of a chosen one.
  struct RivalStart {
    plant::EffectId id = plant::kNameableCount;
    std::vector<double> start = {};  ///< numbers from which its fit starts
    double share = 0.0;              ///< of the chosen one's log gain, that a linear step promises
  };
  /// The most promising beside `less`, the chosen hypothesis without an effect. Notes the best share as the runner-up's.
  std::vector<RivalStart> promised_rivals(const Hypothesis& less, plant::EffectId effect);
  /// The chosen hypothesis with rivals in the place of an effect, each with its name. They are those that a linear step
  /// promises to explain much of it, and those that did so when either was added. The steps are taken beside the other
  /// effects as they are, and as they are fitted alone.
  std::vector<std::pair<plant::EffectId, Hypothesis>> rivals_of(plant::EffectId effect);
  /// Takes `other`, which has `rival` in the place of `effect`, or notes how near it is.
  Exchange compare(plant::EffectId effect, plant::EffectId rival, const Hypothesis& other);
  bool are_tied(plant::EffectId chosen, plant::EffectId rival) const;
  /// True if a general form may stand beside the chosen ones in place of its special case, by where its fits begin.
  bool may_be_added_as_general(plant::EffectId id) const;
  /// True if `with` explains sufficiently more by an effect's general form than `special` by its special case.
  bool explains_more_than_special(plant::EffectId general, const Hypothesis& special, const Hypothesis& with) const;
  /// Puts the general form of a chosen effect in its place, if a channel on which it shows is open and it explains more.
  bool generalise();
  /// Puts the special case in the place of a chosen general form that explains no more.
  void specialise();
  /// Notes a rival that explains nearly the same.
  void note_tie(Tie tie, double chance);
  /// Forgets ties of effects that are no longer chosen.
  void forget_ties();
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
  /// it is better, reduced for a lead that is small or small beside what `one` leaves unexplained. Such leads come from details
  /// that neither has.
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
  std::vector<Hypothesis> first_of_channel_;       ///< accepted later as the first on a channel, but not the best there
  bool regrows_ = false;                           ///< a set has grown, and another grows
  std::map<plant::EffectId, Hypothesis> without_;  ///< by effect, of the chosen hypothesis as it is
  std::vector<std::vector<Candidate>> rounds_;
  std::map<std::vector<plant::EffectId>, double> reached_;  ///< best score of each set that growths reached, sorted
  std::vector<plant::EffectId> once_;                       ///< that show in one half alone
  /// Numbers of the second effect of a pair, by half, where both explained nearly the same when one was added.
  std::map<std::pair<plant::EffectId, plant::EffectId>, std::array<std::vector<double>, 2>> rivals_;
  std::vector<Tie> ties_;
  std::array<double, plant::kNameableCount> chance_{};     ///< that no rival of it explains more
  std::array<double, plant::kNameableCount> runner_up_{};  ///< as in Evidence
};

}  // namespace farrier::diagnosis
