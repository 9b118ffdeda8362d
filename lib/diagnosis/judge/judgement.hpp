#pragma once

// Rules by which effects are named: docs/decisions/0035-diagnosis.md.

#include <functional>
#include <string>
#include <vector>

#include "diagnosis/confidence/confidence.hpp"
#include "diagnosis/judge/hypothesis.hpp"
#include "diagnosis/judge/remainder.hpp"

namespace farrier::diagnosis {

enum class Verdict { kEffects, kNone, kCannotSeparate, kUnknown, kNotExcited, kBadData, kWiring };
const char* to_string(Verdict verdict) noexcept;

/// Bounds of the rules.
struct Rules {
  std::size_t most_effects = 6;
  bool screens = true;          ///< linearised steps choose what is fitted; false: every effect is, from all its starts
  std::size_t most_fitted = 5;  ///< effects of a channel that are fitted in a round, the most promising first
  double near_best = 0.4;       ///< of the best sketch's promise, below which an effect is not fitted in full
  std::size_t most_regrown = 3;   ///< other first effects from which another set is grown
  double price_of_effect = 0.03;  ///< log gain that an effect must bring for a larger set to be the better one
  double least_promise = 0.5;     ///< of least_reduction, that a linearised step must predict before a fit is tried
  double least_exchange =
      0.25;  ///< of an effect's log gain, that another must promise in its place before it is fitted
  std::size_t most_exchanged = 2;  ///< effects that are fitted in the place of a chosen one, the most promising first
  double least_reduction = 0.08;   ///< of a channel's held-out rms, that an effect must bring
  double neutral_deviations =
      4.0;  ///< by which a parameter must lie outside its neutral band: a robot has hundreds of them
  double load_band =
      2.0 * kNominalBand;        ///< share by which a number of the load may be off its file and is no effect: it
                                 ///< takes up errors of the force sensor and the piston, too
  double least_step = 0.04;      ///< of a channel's rms before any effect, that the first effect must remove
  double further_step = 0.006;   ///< the same of further ones, which may be details of the first
  double structure_ratio = 1.6;  ///< rms over that of a twin, above which a remainder has a structure
  double open_ratio = 1.15;      ///< rms over that of a twin with its sensors' noise, above which there may be more
  double unexplained = 0.2;      ///< of a channel's rms before any effect, above which a remainder is no detail
  double least_nrmse = 0.02;     ///< NRMSE that a simulation of this form cannot improve
  double sure =
      0.9;  ///< confidence of the name with the largest share, from which a remainder does not make it unknown
  double likely = 0.5;             ///< confidence that one name must have, else no known effect explains the recording
  double least_confidence = 0.05;  ///< below which an effect beside others is not named
  const ConfidenceMap* confidence = &confidence_map(false);  ///< outlives the rules
  double tie_chance = 0.025;     ///< chance of being right above which a rival cannot be excluded
  double clear_structure = 2.0;  ///< lead in squares over what is left beside noise, from which the lead counts in full
  double clear_lead = 0.05;      ///< of a channel's held-out rms, from which a lead over a rival counts in full
};

/// One effect that was named.
struct NamedEffect {
  plant::EffectId id;
  std::vector<double> fitted;  ///< numbers of its parameters
  double deviation;            ///< standard deviation of the first: 1.96 of it cover as often as they say
  double share;                ///< of the whole log gain
  double confidence;           ///< calibrated probability that it is present
  Evidence evidence = {};      ///< from which the confidence follows
  double fit_deviation = 0.0;  ///< standard deviation of the first by the fits alone
  double distance = 0.0;       ///< of the first from its neutral value
};

/// One line of the table of candidates, for reports.
struct Candidate {
  plant::EffectId id;
  Gain gain;
  double fitted, deviation;
  bool accepted;
};

struct Judgement {
  Verdict verdict = Verdict::kNone;
  std::vector<NamedEffect> effects;                                       ///< by share, largest first
  std::vector<std::pair<plant::EffectId, plant::EffectId>> alternatives;  ///< that this recording does not tell apart
  std::vector<Hypothesis> rivals;                                         ///< with the second of each alternative
  std::vector<plant::EffectId> not_judged;                                ///< that it could not show
  std::vector<std::vector<Candidate>> rounds;                             ///< of forward selection
  Hypothesis base, chosen;
  Gain gain{};                              ///< from base to chosen
  std::array<Remainder, kChannels> left{};  ///< after `chosen`
  bool unexplained = false;                 ///< a channel's remainder has a structure and is no detail
};

/// Runs `count` pieces of work, possibly in parallel.
using ForEach = std::function<void(std::size_t count, const std::function<void(std::size_t)>&)>;

Judgement judge(const Bench& bench, const ExpectedResiduals& expected, const Rules& rules, const ForEach& for_each);

}  // namespace farrier::diagnosis
