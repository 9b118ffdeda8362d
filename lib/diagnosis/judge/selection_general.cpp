// General forms of effects, EffectInfo::special_case: named in place of their special cases alone, and where those
// explain less.

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "diagnosis/judge/selection.hpp"

namespace farrier::diagnosis {
namespace {

/// Share of a parameter's range next to its ends: a number there models something else.
constexpr double kEndShare = 0.01;

/// Number of parameters that a general form has in common with its special case: its first ones.
std::size_t common_parameters(plant::EffectId general) {
  return plant::effect_info(plant::special_case_of(general)).parameters.size();
}

/// True if the further numbers of a general form lie within their ranges.
bool within_ranges(plant::EffectId general, const std::vector<double>& fitted) {
  const auto& parameters = plant::effect_info(general).parameters;
  for (std::size_t i = common_parameters(general); i < parameters.size(); ++i) {
    const double margin = kEndShare * (parameters[i].high - parameters[i].low);
    if (fitted[i] < parameters[i].low + margin || fitted[i] > parameters[i].high - margin) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool may_be_added(const Hypothesis& to, plant::EffectId id) {
  return !plant::is_general_form(id) && !holds(to, id) && !holds(to, plant::general_form_of(id));
}

bool Selection::may_be_added_as_general(plant::EffectId id) const {
  return plant::is_general_form(id) && may_be_added(chosen_, plant::special_case_of(id)) &&
         std::ranges::any_of(bench_.simulator().starts(id),
                             [id](const std::vector<double>& start) { return within_ranges(id, start); });
}

bool Selection::explains_more_than_special(plant::EffectId general, const Hypothesis& special,
                                           const Hypothesis& with) const {
  const auto index = static_cast<std::size_t>(std::ranges::find(with.effects, general) - with.effects.begin());
  const Estimate estimate = pooled(with, index);
  return !at_bound(general, estimate) && within_ranges(general, estimate.fitted) && adds_to(special, with);
}

bool Selection::generalise() {
  const ChannelMask open = open_channels();
  for (const plant::EffectId special : chosen_.effects) {
    const plant::EffectId general = plant::general_form_of(special);
    if (general == plant::kNameableCount || !meet(bench_.simulator().channels(general), open)) {
      continue;
    }
    const auto& starts = bench_.simulator().starts(general);
    const auto start =
        std::ranges::find_if(starts, [general](const auto& numbers) { return within_ranges(general, numbers); });
    if (start == starts.end()) {
      continue;
    }
    const Hypothesis with = bench_.exchanged(chosen_, special, general, {*start, *start});
    if (explains_more_than_special(general, chosen_, with)) {
      const Estimate estimate = pooled(with, with.effects.size() - 1);
      rounds_.push_back({{general, bench_.gain(chosen_, with), estimate.fitted[0], estimate.deviation, true}});
      choose(bench_.refined(with));
      return true;
    }
  }
  return false;
}

void Selection::specialise() {
  for (const plant::EffectId general : chosen_.effects) {
    if (!plant::is_general_form(general)) {
      continue;
    }
    const auto index = static_cast<std::size_t>(std::ranges::find(chosen_.effects, general) - chosen_.effects.begin());
    std::array<std::vector<double>, 2> numbers;
    for (std::size_t half = 0; half < 2; ++half) {
      numbers[half] = chosen_.halves[half].model.effects[index].fitted;
      numbers[half].resize(common_parameters(general));
    }
    Hypothesis special = bench_.exchanged(chosen_, general, plant::special_case_of(general), numbers);
    if (!explains_more_than_special(general, special, chosen_)) {
      choose(std::move(special));
      return;
    }
  }
}

}  // namespace farrier::diagnosis
