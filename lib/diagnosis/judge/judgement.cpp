#include "diagnosis/judge/judgement.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "diagnosis/data/sample_statistics.hpp"
#include "diagnosis/judge/selection.hpp"

namespace farrier::diagnosis {
namespace {

std::array<Remainder, kChannels> remainder(const Bench& bench, const Hypothesis& hypothesis,
                                           const ExpectedResiduals& expected_residuals) {
  std::array<Remainder, kChannels> left{};
  const auto expected = expected_residuals(hypothesis);
  const double warm = 2.0 * bench.options().warm_up_s / bench.simulator().period_s();
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (bench.fit_data().judged[c]) {
      const double count = static_cast<double>(bench.simulator().size()) - warm;
      left[c].rms = std::sqrt(hypothesis.total(c) / count);
      left[c].expected = expected[c];
      left[c].nrmse = left[c].rms / standard_deviation(bench.simulator().measured(static_cast<Channel>(c)));
    }
  }
  return left;
}

/// True if a channel's remainder is more than its sensors' noise.
bool is_structured(const Remainder& left, const Rules& rules) {
  return left.nrmse > rules.least_nrmse && left.rms > rules.structure_ratio * left.expected;
}

/// True if an effect beside a larger one shows where a remainder is no noise. It may then be a part that the larger
/// one's model lacks.
bool may_be_a_detail(plant::EffectId id, const std::array<Remainder, kChannels>& left, const Rules& rules) {
  ChannelMask structured{};
  std::ranges::transform(left, structured.begin(), [&](const Remainder& one) { return is_structured(one, rules); });
  return meet(channels_of(id), structured);
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
  Selection selection(bench, rules, for_each);
  Judgement judgement;
  judgement.base = selection.base();
  const auto before = remainder(bench, judgement.base, expected);
  ChannelMask open = bench.fit_data().judged;
  for (std::size_t round = 0; round < rules.most_effects && selection.add(open); ++round) {
    const auto left = remainder(bench, selection.chosen(), expected);
    for (std::size_t c = 0; c < kChannels; ++c) {
      open[c] = bench.fit_data().judged[c] && left[c].rms > rules.open_ratio * left[c].expected &&
                left[c].rms > rules.further_step * before[c].rms;
    }
    if (std::ranges::none_of(open, std::identity{})) {
      break;
    }
  }
  selection.prune();
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
    further.confidence *= may_be_a_detail(further.id, judgement.left, rules) ? rules.confidence_if_unknown : 1.0;
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
