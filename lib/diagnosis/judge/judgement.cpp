#include "diagnosis/judge/judgement.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/judge/remainder.hpp"
#include "diagnosis/judge/selection.hpp"

namespace farrier::diagnosis {
namespace {

/// True if a channel's remainder is more than its sensors' noise.
bool is_structured(const Remainder& left, const Rules& rules) {
  return left.nrmse > rules.least_nrmse && left.rms > rules.structure_ratio * left.expected;
}

/// True if an effect beside a larger one shows where a remainder is no noise. It may then be a part that the larger
/// one's model lacks.
bool may_be_a_detail(const ChannelMask& shows, const std::array<Remainder, kChannels>& left, const Rules& rules) {
  ChannelMask structured{};
  std::ranges::transform(left, structured.begin(), [&](const Remainder& one) { return is_structured(one, rules); });
  return meet(shows, structured);
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
  const auto& before = selection.before();
  selection.grow();
  selection.grow_from_others();
  selection.exchange();
  selection.compare_rivals();
  judgement.chosen = selection.chosen();
  judgement.rounds = selection.rounds();
  for (const Selection::Tie& tie : selection.ties()) {
    judgement.alternatives.emplace_back(tie.chosen, tie.rival);
    judgement.rivals.push_back(tie.with_rival);
  }
  judgement.left = remainder(bench, judgement.chosen, expected);
  judgement.gain = bench.gain(judgement.base, judgement.chosen);
  for (std::size_t i = 0; i < judgement.chosen.effects.size(); ++i) {
    const plant::EffectId id = judgement.chosen.effects[i];
    const Estimate estimate = pooled(judgement.chosen, i);
    judgement.effects.push_back(
        {id, estimate.fitted, estimate.deviation, selection.share_of(id), selection.confidence(id)});
  }
  std::ranges::stable_sort(judgement.effects, std::greater{}, &NamedEffect::share);
  bool structured = false;
  for (std::size_t c = 0; c < kChannels; ++c) {
    const Remainder& left = judgement.left[c];
    structured = structured || (is_structured(left, rules) && left.rms > rules.unexplained * before[c].rms);
  }
  for (std::size_t i = 1; i < judgement.effects.size(); ++i) {
    NamedEffect& further = judgement.effects[i];
    further.confidence *= may_be_a_detail(bench.simulator().channels(further.id), judgement.left, rules)
                              ? rules.confidence_if_unknown
                              : 1.0;
  }
  for (NamedEffect& effect : judgement.effects) {
    effect.confidence *= structured ? rules.confidence_if_unknown : 1.0;
  }
  judgement.verdict = structured                        ? Verdict::kUnknown
                      : judgement.effects.empty()       ? Verdict::kNone
                      : !judgement.alternatives.empty() ? Verdict::kCannotSeparate
                                                        : Verdict::kEffects;
  return judgement;
}

}  // namespace farrier::diagnosis
