#include "robot/sections/joint_effects_section.hpp"

#include <limits>
#include <string>
#include <string_view>

namespace farrier::robot {
namespace {

using config::Range;
using config::Visitor;
using plant::Parameter;
using plant::Scale;

const char* text_of(plant::Side side) {
  switch (side) {
    case plant::Side::kValveAndOil:
      return "Effect between the current and the load cell.";
    case plant::Side::kLoad:
      return "Effect behind the load cell.";
    case plant::Side::kForceSensor:
      return "Effect of the load cell.";
    case plant::Side::kVelocitySensor:
      return "Effect of the velocity sensor.";
  }
  return "";
}

/// Unit of a scale's ranges, as text. Empty: the parameter's own unit, the same for every joint.
std::string text_of(Scale scale) {
  switch (scale) {
    case Scale::kOne:
    case Scale::kSecond:
    case Scale::kRate:
      return "";
    case Scale::kCurrent:
      return "the valve's current_max_A";
    case Scale::kForce:
      return "the supply pressure times the larger area";
    case Scale::kLength:
      return "the stroke";
    case Scale::kSpeed:
      return "the speed that the full valve gives";
    case Scale::kLeakage:
      return "the full valve's flow at supply pressure over that pressure";
    case Scale::kDroop:
      return "the supply pressure over the full valve's flow at it";
    case Scale::kMass:
      return "the mass or inertia of the swing load";
    case Scale::kDamping:
      return "the damping of the swing load, or a hundredth of full push over full speed";
    case Scale::kStiffness:
      return "the stiffness of the swing load, or a fifth of full push over stroke";
    case Scale::kCubic:
      return "the stiffness of the swing load, or a fifth of full push over stroke, over the stroke's square";
  }
  return "";
}

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
    const std::string scale = text_of(p.scale);
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
            text_of(info.side));
  }
}

}  // namespace farrier::robot
