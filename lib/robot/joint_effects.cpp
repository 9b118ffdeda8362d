#include "robot/joint_effects.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "plant/effects/effects.hpp"
#include "plant/terms/load_effects.hpp"

namespace farrier::robot {
namespace {

using config::number_text;

/// Values that another program wrote may lie on an end of their range but for the last digits.
constexpr double kRounding = 1e-9;

std::string give(const plant::ParameterRange& range) {
  return "give " + number_text(range.low) + " to " + number_text(range.high);
}

class EffectReader {
 public:
  explicit EffectReader(const Joint& joint) : joint_(joint) {}

  plant::ActiveEffect read(EffectSection& section) {
    plant::ActiveEffect effect{section.id, {}};
    const std::size_t presliding = find_parameter(effect.info(), "presliding_m");
    const bool bends = presliding < effect.info().parameters.size();
    const bool tells = bends && (section.values[presliding] || section.rotary_values[presliding]);
    for (std::size_t i = 0; i < effect.info().parameters.size(); ++i) {
      effect.values[i] = read(section, effect.info().parameters[i], i);
    }
    if (tells) {
      check_bristles(section, effect, presliding);
    }
    if (bends) {
      check_bristle_damping(section, effect);
    }
    return effect;
  }

  config::Problems take_problems() && { return std::move(problems_); }

 private:
  /// A contact that the file lets bend less than a substep can follow.
  void check_bristles(const EffectSection& section, const plant::ActiveEffect& effect, std::size_t presliding) {
    const plant::Parameter& parameter = effect.info().parameters[presliding];
    const double least = plant::least_presliding(joint_.actuator, effect);
    const double usual = plant::default_value(parameter, scales_, joint_.actuator, joint_.swing_load);
    if (effect.values[presliding] < std::min(least, (1.0 - kRounding) * usual)) {
      problems_.push_back(section.place.problem(joint_.rotary ? parameter.rotary_name : parameter.name,
                                                number_text(effect.values[presliding]) +
                                                    " makes bristles stiffer than the shortest step of the simulation "
                                                    "allows at this joint's full speed: give at least " +
                                                    number_text(std::ceil(1e7 * least) / 1e7)));
    }
  }

  /// Bristles that would give energy back within the joint's speeds (Barabanov and Ortega 2000).
  void check_bristle_damping(const EffectSection& section, const plant::ActiveEffect& effect) {
    const double most = 4.0 * plant::least_coulomb(effect) / plant::velocity_scale(joint_.actuator);
    const double damping = *plant::parameter_value(effect, "bristle_damping_Ns_m");
    if (damping > most) {
      problems_.push_back(section.place.problem(joint_.rotary ? "bristle_damping_Nms_rad" : "bristle_damping_Ns_m",
                                                number_text(damping) +
                                                    " gives energy back at this joint's full speed: give at most " +
                                                    number_text(std::floor(1e2 * most) / 1e2)));
    }
  }

  double read(EffectSection& section, const plant::Parameter& parameter, std::size_t i) {
    const bool one_name = std::string_view(parameter.name) == parameter.rotary_name;
    const bool by_rotary_name = joint_.rotary && !one_name;
    std::optional<double>& value = by_rotary_name ? section.rotary_values[i] : section.values[i];
    const std::optional<double>& other = by_rotary_name ? section.values[i] : section.rotary_values[i];
    const char* const name = joint_.rotary ? parameter.rotary_name : parameter.name;
    const plant::ParameterRange range = plant::range_of(parameter, scales_);
    if (other) {
      problems_.push_back(section.place.problem(
          joint_.rotary ? parameter.name : parameter.rotary_name,
          std::string("is for a ") + (joint_.rotary ? "cylinder" : "rotary motor") + ": of this joint it is " + name));
    } else if (!value && i == 0) {
      problems_.push_back(
          section.place.problem(name, "is missing: " + give(range) + " (" + std::string(parameter.meaning) + ")"));
    } else if (!value) {
      value = plant::default_value(parameter, scales_, joint_.actuator, joint_.swing_load);
    } else if (const double slack = kRounding * std::max(std::abs(range.low), std::abs(range.high));
               !(*value >= range.low - slack && *value <= range.high + slack)) {
      problems_.push_back(
          section.place.problem(name, number_text(*value) + " is out of this joint's range: " + give(range)));
    }
    return value.value_or(0.0);
  }

  const Joint& joint_;
  plant::Scales scales_{joint_.actuator, joint_.swing_load};
  config::Problems problems_;
};

/// An effect that the joint already has gets the new numbers.
void put_beside(Joint& joint, std::span<const plant::ActiveEffect> effects) {
  for (const plant::ActiveEffect& effect : effects) {
    const auto old = std::ranges::find(joint.effects, effect.id, &plant::ActiveEffect::id);
    if (old != joint.effects.end()) {
      *old = effect;
    } else {
      joint.effects.push_back(effect);
    }
  }
}

/// Those of `effects` that are other loads.
Result<Done> put_into_loads(Joint& joint, std::span<const plant::ActiveEffect> effects) {
  const plant::Loads loads = plant::loads_with_effects({joint.swing_load, joint.stance_load}, joint.actuator, effects);
  for (const plant::LoadParams& load : {loads.swing, loads.stance}) {
    if (const auto good = plant::validate(load); !good) {
      return Error{"leave no load in swing or stance: " + good.error().message +
                   "; the stance load changes as the swing load does"};
    }
  }
  joint.swing_load = loads.swing;
  joint.stance_load = loads.stance;
  return Done{};
}

/// Adds the effects of one section.
config::Problems add_section(JointEffectsSection& section, Joint& joint) {
  EffectReader reader(joint);
  std::vector<plant::ActiveEffect> effects;
  for (std::optional<EffectSection>& effect : section.effects) {
    if (effect) {
      effects.push_back(reader.read(*effect));
    }
  }
  config::Problems problems = std::move(reader).take_problems();
  if (effects.empty()) {
    problems.push_back(section.place.problem("", "is empty: name an effect, or leave the joint out"));
  }
  if (!problems.empty()) {
    return problems;
  }
  put_beside(joint, effects);
  if (const auto put = put_into_loads(joint, effects); !put) {
    problems.push_back(section.place.problem("", put.error().message));
  }
  return problems;
}

}  // namespace

config::Problems add_effects(config::Named<JointEffectsSection>& sections, const std::string& kind, Joint& joint) {
  config::Problems problems;
  for (const std::string& name : {kind, joint.name}) {
    for (auto& [named, section] : sections) {
      if (named == name) {
        const config::Problems misfits = add_section(section, joint);
        problems.insert(problems.end(), misfits.begin(), misfits.end());
      }
    }
  }
  return problems;
}

Result<Joint> with_effects(const Joint& joint, std::span<const plant::ActiveEffect> effects) {
  Joint extended = joint;
  put_beside(extended, effects);
  if (const auto put = put_into_loads(extended, effects); !put) {
    return Error{joint.name + ": its effects " + put.error().message};
  }
  return extended;
}

}  // namespace farrier::robot
