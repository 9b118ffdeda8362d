#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "plant/terms/terms.hpp"

namespace farrier::plant {

/// Most parameters that an effect has.
inline constexpr std::size_t kMostParameters =
    std::ranges::max(AllTerms<double>::kInfos, {}, [](const EffectInfo* info) {
      return info->parameters.size();
    })->parameters.size();

/// An effect that a joint has, with numbers as a robot file has them.
struct ActiveEffect {
  EffectId id = kEffectCount;
  std::array<double, kMostParameters> values{};  ///< SI, actuator coordinates, in the order of EffectInfo::parameters

  const EffectInfo& info() const noexcept { return effect_info(id); }
  friend bool operator==(const ActiveEffect&, const ActiveEffect&) = default;
};

/// Place of a term in AllTerms. By its name: sanitizers do not let a compiler compare addresses.
template <template <class> class Term>
constexpr EffectId effect_id() {
  return find_effect(Term<double>::kInfo.name);
}

/// Place of the parameter that has this name on a cylinder or on a motor; parameters.size() for none.
constexpr std::size_t find_parameter(const EffectInfo& info, std::string_view name) {
  std::size_t place = 0;
  while (place < info.parameters.size() && name != info.parameters[place].name &&
         name != info.parameters[place].rotary_name) {
    ++place;
  }
  return place;
}

/// The effect of that kind, null for none.
inline const ActiveEffect* find(std::span<const ActiveEffect> effects, EffectId id) noexcept {
  const auto found = std::ranges::find(effects, id, &ActiveEffect::id);
  return found == effects.end() ? nullptr : &*found;
}

/// Value of a parameter by one of its names; none where the effect has none of that name.
inline std::optional<double> parameter_value(const ActiveEffect& effect, std::string_view name) noexcept {
  const std::size_t place = find_parameter(effect.info(), name);
  return place < effect.info().parameters.size() ? std::optional(effect.values[place]) : std::nullopt;
}

/// Converts the parameters of an effect to fitted numbers, and back.
inline std::array<double, kMostParameters> fitted_of(const ActiveEffect& effect, const Scales& scales) noexcept {
  std::array<double, kMostParameters> fitted{};
  for (std::size_t i = 0; i < effect.info().parameters.size(); ++i) {
    fitted[i] = scales.fitted(effect.info().parameters[i], effect.values[i]);
  }
  return fitted;
}
/// `fitted` has a number for each parameter.
inline ActiveEffect active_effect(EffectId id, std::span<const double> fitted, const Scales& scales) noexcept {
  ActiveEffect effect{id, {}};
  for (std::size_t i = 0; i < effect.info().parameters.size(); ++i) {
    effect.values[i] = scales.value(effect.info().parameters[i], fitted[i]);
  }
  return effect;
}

/// Range of a parameter, in the unit of the file.
inline ParameterRange range_of(const Parameter& parameter, const Scales& scales) noexcept {
  const ParameterRange multiples = parameter.multiples();
  return {multiples.low * scales.of(parameter.scale), multiples.high * scales.of(parameter.scale)};
}

/// Value of a parameter that is not given: the start of its fit. Slack of a spring: the nominal load's, or mid-stroke
/// of a load without a spring.
inline double default_value(const Parameter& parameter, const Scales& scales, const ActuatorParams& actuator,
                            const LoadParams& load) noexcept {
  if (std::string_view(parameter.name).starts_with("slack_position")) {
    return load.stiffness > 0.0 ? load.equilibrium_position : 0.5 * actuator.stroke;
  }
  return scales.value(parameter, parameter.starts[0]);
}

/// Puts an effect into a set whose hooks are called every `step_s`.
inline void add_to(TermSet<double>& terms, const ActiveEffect& effect, const Scales& scales, double step_s) noexcept {
  terms.add(effect.id, fitted_of(effect, scales).data(), scales, step_s);
}

/// The hysteresis of the valve with its state; none if it is not among the effects.
inline std::optional<ValveHysteresis<double>> hysteresis_of(std::span<const ActiveEffect> effects,
                                                            const Scales& scales) noexcept {
  const ActiveEffect* effect = find(effects, effect_id<ValveHysteresis>());
  return effect != nullptr ? std::optional(ValveHysteresis<double>(fitted_of(*effect, scales).data(), scales, 0.0))
                           : std::nullopt;
}

}  // namespace farrier::plant
