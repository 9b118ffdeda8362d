#include "robot/sections/joint_effects_section.hpp"

#include <limits>
#include <string>
#include <string_view>

#include "plant/terms/term_text.hpp"

namespace farrier::robot {
namespace {

using config::Range;
using config::Visitor;
using plant::Parameter;

std::string fallback_text(const Parameter& p, bool first, const std::string& scale) {
  if (first) {
    return " Required.";
  }
  if (std::string_view(p.name).starts_with("slack_position")) {
    return " Default: where the swing load's spring is slack, or mid-stroke where it has none.";
  }
  const double factor = p.reciprocal ? 1.0 / p.starts[0] : p.starts[0];
  return " Default: " + config::number_text(factor) + (scale.empty() ? "." : " times that.");
}

}  // namespace

void declare(Visitor& v, EffectSection& effect) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  v.here(effect.place);
  const plant::EffectInfo& info = plant::effect_info(effect.id);
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    const Parameter& p = info.parameters[i];
    const std::string scale = plant::text_of(p.scale).phrase;
    const plant::ParameterRange allowed = p.multiples();
    std::string sentence = p.meaning;
    if (!scale.empty()) {
      sentence += " From " + config::number_text(allowed.low) + " to " + config::number_text(allowed.high) + " times " +
                  scale + ".";
    }
    sentence += fallback_text(p, i == 0, scale);
    const Range range = scale.empty() ? Range{allowed.low, allowed.high} : Range{-kAny, kAny};
    v.number(p.name, effect.values[i], range, sentence.c_str());
    if (std::string_view(p.name) != p.rotary_name) {
      v.number(p.rotary_name, effect.rotary_values[i], range, "The same of a rotary motor.");
    }
  }
}

void declare(Visitor& v, JointEffectsSection& joint) {
  v.here(joint.place);
  for (plant::EffectId id = 0; id < plant::kEffectCount; ++id) {
    const plant::EffectInfo& info = plant::effect_info(id);
    v.group(info.name, joint.effects[id], EffectSection{.id = id, .values = {}, .rotary_values = {}, .place = {}},
            plant::text_of(info.side).sentence);
  }
}

}  // namespace farrier::robot
