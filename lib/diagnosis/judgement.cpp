#include "diagnosis/judgement.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/sample_statistics.hpp"

namespace farrier::diagnosis {
namespace {

struct Estimate {
  std::vector<double> fitted;
  double deviation;
};

/// Of the effect at `index` of both halves' models: means, and a deviation no smaller than what the halves differ by.
Estimate pooled(const Hypothesis& hypothesis, std::size_t index) {
  const auto number = [&](std::size_t half) -> const std::vector<double>& {
    return hypothesis.halves[half].model.effects[index].fitted;
  };
  std::size_t place = 0;
  for (std::size_t i = 0; i < index; ++i) {
    place += hypothesis.halves[0].model.effects[i].fitted.size();
  }
  Estimate estimate{number(0), 0.0};
  for (std::size_t i = 0; i < estimate.fitted.size(); ++i) {
    estimate.fitted[i] = 0.5 * (number(0)[i] + number(1)[i]);
  }
  const double a = hypothesis.halves[0].deviation[place];
  const double b = hypothesis.halves[1].deviation[place];
  estimate.deviation = std::max(0.5 * std::sqrt(a * a + b * b), 0.5 * std::abs(number(0)[0] - number(1)[0]));
  return estimate;
}

bool outside_neutral(const Bench& bench, plant::EffectId id, const Estimate& estimate, const Rules& rules) {
  const plant::EffectInfo& info = plant::effect_info(id);
  const std::vector<double>* known = bench.simulator().known(id);
  const double neutral = known != nullptr ? (*known)[0] : bench.simulator().scales().neutral(info.parameters[0]);
  const double nominal = info.nominal || known != nullptr ? kNominalBand * std::abs(neutral) : 0.0;
  const double band = std::max(nominal, bench.simulator().least(id));
  return std::abs(estimate.fitted[0] - neutral) > band + rules.neutral_deviations * estimate.deviation;
}

/// Whether a fit ended where a parameter may go no further: then it is not what the effect is for.
bool at_bound(plant::EffectId id, const Estimate& estimate) {
  const plant::Parameter& first = plant::effect_info(id).parameters[0];
  const double margin = 0.01 * (first.high - first.low);
  return estimate.fitted[0] > first.high - margin || (first.low < 0.0 && estimate.fitted[0] < first.low + margin);
}

/// Whether an effect takes away enough of some channel.
bool worth_it(const Hypothesis& base, const Hypothesis& before, const Hypothesis& after, const Rules& rules) {
  for (std::size_t c = 0; c < kChannels; ++c) {
    const double was = before.total(c);
    const double is = after.total(c);
    const double share = before.effects.empty() ? rules.least_step : rules.further_step;
    const double step = share * share * base.total(c);
    const double ratio = 1.0 - rules.least_reduction;
    if (was > 0.0 && is < ratio * ratio * was && was - is > step) {
      return true;
    }
  }
  return false;
}

struct Tried {
  std::optional<Hypothesis> hypothesis;
  Estimate estimate;  ///< of the effect that is tried
  Gain gain{};
  bool accepted = false;
};

std::vector<Tried> try_all(const Bench& bench, const Hypothesis& base, const Hypothesis& from, const ChannelMask& open,
                           const Rules& rules, const ForEach& for_each) {
  std::vector<Tried> tried(plant::kEffectCount);
  for_each(plant::kEffectCount, [&](std::size_t id) {
    const ChannelMask mine = channels_of(plant::effect_info(id).side);
    const bool seen = (mine[0] && open[0]) || (mine[1] && open[1]) || (mine[2] && open[2]);
    if (!seen || std::ranges::find(from.effects, id) != from.effects.end()) {
      return;
    }
    Tried& mine_tried = tried[id];
    mine_tried.hypothesis = bench.with(from, id, 0.5 * rules.least_reduction);
    if (mine_tried.hypothesis) {
      const Hypothesis& with = *mine_tried.hypothesis;
      mine_tried.gain = bench.gain(from, with);
      mine_tried.estimate = pooled(with, with.effects.size() - 1);
      const Gain& gain = mine_tried.gain;
      mine_tried.accepted = !at_bound(id, mine_tried.estimate) && gain.low > 0.0 && gain.by_half[0] > 0.0 &&
                            gain.by_half[1] > 0.0 && worth_it(base, from, with, rules) &&
                            outside_neutral(bench, id, mine_tried.estimate, rules);
    }
  });
  return tried;
}

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
  }
  return "";
}

Judgement judge(const Bench& bench, const ExpectedResiduals& expected, const Rules& rules, const ForEach& for_each) {
  Judgement judgement;
  judgement.base = bench.base();
  judgement.chosen = judgement.base;
  const auto before = remainder(bench, judgement.base, expected);
  judgement.left = before;
  ChannelMask open = bench.fit_data().judged;
  std::vector<double> confidences;
  for (std::size_t round = 0; round < rules.most_effects; ++round) {
    std::vector<Tried> tried = try_all(bench, judgement.base, judgement.chosen, open, rules, for_each);
    std::vector<Candidate> lines;
    plant::EffectId best = plant::kEffectCount;
    for (plant::EffectId id = 0; id < plant::kEffectCount; ++id) {
      if (!tried[id].hypothesis) {
        continue;
      }
      const Estimate& estimate = tried[id].estimate;
      lines.push_back({id, tried[id].gain, estimate.fitted[0], estimate.deviation, tried[id].accepted});
      if (tried[id].accepted &&
          (best == plant::kEffectCount || tried[id].gain.log_ratio > tried[best].gain.log_ratio)) {
        best = id;
      }
    }
    judgement.rounds.push_back(std::move(lines));
    if (best == plant::kEffectCount) {
      break;
    }
    double confidence = 1.0;
    for (plant::EffectId id = 0; id < plant::kEffectCount; ++id) {
      if (id != best && tried[id].accepted) {
        const Gain lead = bench.gain(*tried[id].hypothesis, *tried[best].hypothesis);
        confidence = std::min(confidence, lead.chance);
        if (1.0 - lead.chance > rules.tie_chance) {
          judgement.alternatives.emplace_back(best, id);
          judgement.rivals.push_back(*tried[id].hypothesis);
        }
      }
    }
    confidences.push_back(confidence);
    judgement.chosen = std::move(*tried[best].hypothesis);
    judgement.left = remainder(bench, judgement.chosen, expected);
    bool any = false;
    for (std::size_t c = 0; c < kChannels; ++c) {
      const Remainder& left = judgement.left[c];
      open[c] = bench.fit_data().judged[c] && left.rms > rules.open_ratio * left.expected &&
                left.rms > rules.further_step * before[c].rms;
      any = any || open[c];
    }
    if (!any) {
      break;
    }
  }
  judgement.gain = bench.gain(judgement.base, judgement.chosen);
  for (std::size_t i = 0; i < judgement.chosen.effects.size(); ++i) {
    const Estimate estimate = pooled(judgement.chosen, i);
    double share = 1.0;
    if (judgement.chosen.effects.size() > 1) {
      const Hypothesis less = bench.without(judgement.chosen, judgement.chosen.effects[i]);
      share = bench.gain(less, judgement.chosen).log_ratio / std::max(judgement.gain.log_ratio, 1e-12);
    }
    judgement.effects.push_back(
        {judgement.chosen.effects[i], estimate.fitted, estimate.deviation, share, confidences[i]});
  }
  std::ranges::stable_sort(judgement.effects, std::greater{}, &NamedEffect::share);
  bool structured = false;
  for (std::size_t c = 0; c < kChannels; ++c) {
    const Remainder& left = judgement.left[c];
    structured = structured || (left.nrmse > rules.least_nrmse && left.rms > rules.structure_ratio * left.expected &&
                                left.rms > rules.unexplained * before[c].rms);
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
