#include "diagnosis/judge/judgement.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "diagnosis/judge/remainder.hpp"
#include "diagnosis/judge/selection.hpp"

namespace farrier::diagnosis {
namespace {

/// Share of a channel's rms before any effect that its sensors' noise may stand for. A model with play or friction may hang on
/// its start so much that noise explains any remainder.
constexpr double kMostNoise = 0.2;

/// Remainders after a hypothesis, of which noise explains no more than `before` and kMostNoise allow.
std::array<Remainder, kChannels> remainder_after(const Bench& bench, const Hypothesis& hypothesis,
                                                 const ExpectedResiduals& expected,
                                                 const std::array<Remainder, kChannels>& before) {
  auto left = remainder(bench, hypothesis, expected);
  for (std::size_t c = 0; c < kChannels; ++c) {
    left[c].expected = std::min(left[c].expected, std::max(before[c].expected, kMostNoise * before[c].rms));
  }
  return left;
}

/// True if a channel's remainder is more than its sensors' noise.
bool is_structured(const Remainder& left, const Rules& rules) {
  return left.nrmse > rules.least_nrmse && left.rms > rules.structure_ratio * left.expected;
}

/// Largest remainders over the channels of a mask: over that of noise, and over that before any effect.
std::pair<double, double> largest(const ChannelMask& mask, const std::array<Remainder, kChannels>& left,
                                  const std::array<Remainder, kChannels>& before) {
  double over_noise = 0.0;
  double unexplained = 0.0;
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (mask[c] && before[c].rms > 0.0) {
      over_noise = std::max(over_noise, left[c].rms / std::max(left[c].expected, 1e-12));
      unexplained = std::max(unexplained, left[c].rms / before[c].rms);
    }
  }
  return {over_noise, unexplained};
}

/// The chosen effect at `index` with all that speaks for it.
NamedEffect named(Selection& selection, const Bench& bench, std::size_t index,
                  const std::array<Remainder, kChannels>& left, const ConfidenceMap& map) {
  const Hypothesis& chosen = selection.chosen();
  const plant::EffectId id = chosen.effects[index];
  const Estimate estimate = pooled(chosen, index);
  const double distance = std::abs(estimate.fitted[0] - neutral_value(bench.simulator(), id));
  Evidence evidence = selection.evidence(id);
  std::tie(evidence.own_left, evidence.unexplained) = largest(bench.simulator().channels(id), left, selection.before());
  evidence.all_left = largest({true, true, true}, left, selection.before()).first;
  evidence.share = selection.share_of(id);
  evidence.gain = selection.gain_of(id);
  evidence.deviations = distance / std::max(estimate.deviation, 1e-12);
  evidence.halves_apart = estimate.halves_apart / std::max(distance, 1e-12);
  evidence.effects = static_cast<double>(chosen.effects.size());
  evidence.rivals = static_cast<double>(std::ranges::count(selection.ties(), id, &Selection::Tie::chosen));
  return {.id = id,
          .fitted = estimate.fitted,
          .deviation = covering_deviation(estimate.deviation, distance, map),
          .share = evidence.share,
          .confidence = confidence_of(evidence, map),
          .evidence = evidence,
          .fit_deviation = estimate.deviation,
          .distance = distance};
}

/// The chosen effects, by share.
std::vector<NamedEffect> named(Selection& selection, const Bench& bench, const ExpectedResiduals& expected,
                               const ConfidenceMap& map) {
  const auto left = remainder_after(bench, selection.chosen(), expected, selection.before());
  std::vector<NamedEffect> effects;
  for (std::size_t i = 0; i < selection.chosen().effects.size(); ++i) {
    effects.push_back(named(selection, bench, i, left, map));
  }
  std::ranges::stable_sort(effects, std::greater{}, &NamedEffect::share);
  return effects;
}

/// Names the chosen effects. One that is most likely absent is removed, unless it stands for a rival, too.
std::vector<NamedEffect> named_likely(Selection& selection, const Bench& bench, const ExpectedResiduals& expected,
                                      const Rules& rules) {
  for (;;) {
    std::vector<NamedEffect> effects = named(selection, bench, expected, *rules.confidence);
    const auto tied = [&](plant::EffectId id) {
      return std::ranges::find(selection.ties(), id, &Selection::Tie::chosen) != selection.ties().end();
    };
    const auto least = std::ranges::min_element(
        effects, {}, [&](const NamedEffect& effect) { return tied(effect.id) ? 1.0 : effect.confidence; });
    if (effects.size() < 2 || least->confidence >= rules.least_confidence || tied(least->id)) {
      return effects;
    }
    selection.remove(least->id);
  }
}

}  // namespace

const char* to_string(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::kEffects:
      return "effects";
    case Verdict::kNone:
      return "none";
    case Verdict::kCannotSeparate:
      return "cannot_separate";
    case Verdict::kUnknown:
      return "unknown";
    case Verdict::kNotExcited:
      return "not_excited";
    case Verdict::kBadData:
      return "bad_data";
    case Verdict::kWiring:
      return "wiring";
  }
  return "";
}

Judgement judge(const Bench& bench, const ExpectedResiduals& expected, const Rules& rules, const ForEach& for_each) {
  Selection selection(bench, expected, rules, for_each);
  Judgement judgement;
  judgement.base = selection.base();
  selection.grow();
  selection.grow_from_others();
  selection.grow_from_pairs();
  selection.grow_from_events();
  selection.grow_from_wider();
  selection.exchange();
  selection.tie_inseparable();
  judgement.effects = named_likely(selection, bench, expected, rules);
  judgement.chosen = selection.chosen();
  judgement.rounds = selection.rounds();
  for (const Selection::Tie& tie : selection.ties()) {
    judgement.alternatives.emplace_back(tie.chosen, tie.rival);
    judgement.rivals.push_back(tie.with_rival);
  }
  judgement.left = remainder_after(bench, judgement.chosen, expected, selection.before());
  judgement.gain = bench.gain(judgement.base, judgement.chosen);
  bool sure = !judgement.effects.empty() && judgement.effects.front().confidence >= rules.sure;
  for (std::size_t c = 0; c < kChannels; ++c) {
    const Remainder& left = judgement.left[c];
    const double share = left.rms / std::max(selection.before()[c].rms, 1e-300);
    if (is_structured(left, rules) && share > rules.unexplained) {
      judgement.unexplained = true;
      sure = sure && share < kMostLeft;
    }
  }
  const bool likely = std::ranges::any_of(judgement.effects,
                                          [&](const NamedEffect& effect) { return effect.confidence >= rules.likely; });
  judgement.verdict = judgement.unexplained && !sure    ? Verdict::kUnknown
                      : judgement.effects.empty()       ? Verdict::kNone
                      : !judgement.alternatives.empty() ? Verdict::kCannotSeparate
                      : !likely                         ? Verdict::kUnknown
                                                        : Verdict::kEffects;
  return judgement;
}

}  // namespace farrier::diagnosis
