#include "plant/effects/effects.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace farrier::plant {
namespace {

double full_open(const ActuatorParams& actuator) noexcept { return actuator.valve_gain * actuator.valve_current_max_A; }

Lines make_lines(const ActuatorParams& actuator) noexcept {
  return {actuator.line, actuator.bulk_modulus_Pa, actuator.supply_pressure_Pa,
          full_open(actuator) * std::sqrt(actuator.supply_pressure_Pa),
          full_open(actuator) / std::sqrt(actuator.laminar_pressure_Pa)};
}

SupplyLine supply_line(const ActuatorParams& actuator, std::span<const ActiveEffect> effects) noexcept {
  const ActiveEffect* droop = find(effects, effect_id<SupplyDroop>());
  return droop == nullptr ? SupplyLine()
                          : SupplyLine(*parameter_value(*droop, "resistance_Pa_s_m3"),
                                       *parameter_value(*droop, "time_constant_s"), actuator.supply_pressure_Pa);
}

double full_push(const ActuatorParams& actuator) noexcept {
  return actuator.supply_pressure_Pa * std::max(actuator.area_a, actuator.area_b);
}

/// The contact of a friction effect; none for null. It bends as the term's does, or as far as least_presliding().
FrictionParams contact(const ActuatorParams& actuator, const ActiveEffect* effect) noexcept {
  if (effect == nullptr) {
    return {};
  }
  const double coulomb = *parameter_value(*effect, "coulomb_N");
  return {coulomb, *parameter_value(*effect, "breakaway_ratio") * coulomb,
          *parameter_value(*effect, "stribeck_velocity_m_s"),
          std::max(*parameter_value(*effect, "presliding_m"), least_presliding(actuator, *effect)),
          *parameter_value(*effect, "bristle_damping_Ns_m")};
}

/// The wave of a friction effect; level for null. validate() lets a wavelength of 0 through, which acts as a very short
/// one.
FrictionWave<double> wave(const ActuatorParams& actuator, const ActiveEffect* effect) noexcept {
  constexpr double kShortestShare = 1e-4;  // of the stroke
  if (effect == nullptr) {
    return {0.0, actuator.stroke, 0.0};
  }
  return {*parameter_value(*effect, "waviness"),
          std::max(*parameter_value(*effect, "wavelength_m"), kShortestShare * actuator.stroke),
          *parameter_value(*effect, "tightest_position_m")};
}

}  // namespace

double least_coulomb(const ActiveEffect& friction) noexcept {
  const double waviness = parameter_value(friction, "waviness").value_or(0.0);
  return (1.0 - waviness) * *parameter_value(friction, "coulomb_N");
}

double least_presliding(const ActuatorParams& actuator, const ActiveEffect& friction) noexcept {
  constexpr double kFastestContact_1_s = 3e5;
  const double waviness = parameter_value(friction, "waviness").value_or(0.0);
  return *parameter_value(friction, "breakaway_ratio") / (1.0 - waviness) * velocity_scale(actuator) /
         kFastestContact_1_s;
}

ActuatorParams with_effects(const ActuatorParams& actuator, std::span<const ActiveEffect> effects) noexcept {
  ActuatorParams changed = actuator;
  if (const ActiveEffect* spool = find(effects, effect_id<ValveDynamics>())) {
    changed.spool = {true, *parameter_value(*spool, "natural_frequency_rad_s"), *parameter_value(*spool, "damping")};
  }
  return changed;
}

LoadParams with_effects(const LoadParams& load, const ActuatorParams& actuator,
                        std::span<const ActiveEffect> effects) noexcept {
  LoadParams changed = load;
  if (const ActiveEffect* friction = find(effects, effect_id<LoadFriction>())) {
    changed.friction = contact(actuator, friction);
  }
  if (const ActiveEffect* part = find(effects, effect_id<FlexibleLoad>())) {
    changed.flexible = {*parameter_value(*part, "share_of_mass"), *parameter_value(*part, "natural_frequency_rad_s"),
                        *parameter_value(*part, "damping")};
  }
  return changed;
}

Result<Done> validate(std::span<const ActiveEffect> effects) {
  std::string refused;
  const auto refuse = [&](const std::string& why) { refused += (refused.empty() ? "" : "; ") + why; };
  for (const ActiveEffect& effect : effects) {
    if (effect.id >= kEffectCount) {
      refuse("effects: number " + std::to_string(effect.id) + " is none");
      continue;
    }
    if (find(effects, effect.id) != &effect) {
      refuse("effects: " + std::string(effect.info().name) + " is there twice");
    }
    Refusals refusals(effect.info().name);
    for (std::size_t i = 0; i < effect.info().parameters.size(); ++i) {
      const Parameter& parameter = effect.info().parameters[i];
      const double value = effect.values[i];
      if (parameter.reciprocal) {
        refusals.positive(parameter.name, value);
      } else if (std::string_view(parameter.name) == "waviness") {
        refusals.require(value >= 0.0 && value < 1.0, parameter.name, value, "within [0, 1)");
      } else if (parameter.low >= 0.0) {
        refusals.not_negative(parameter.name, value);
      } else {
        refusals.require(true, parameter.name, value, "finite");
      }
    }
    if (const auto verdict = refusals.verdict(); !verdict) {
      refuse(verdict.error().message);
    }
  }
  return refused.empty() ? Result<Done>(Done{}) : Result<Done>(Error{refused});
}

Effects::Effects(const ActuatorParams& actuator, const LoadParams& load, std::span<const ActiveEffect> effects,
                 double tolerance) noexcept
    : EffectSet(Spool(actuator.spool, actuator.valve_current_max_A), supply_line(actuator, effects),
                make_lines(actuator), Friction(load.friction, full_push(actuator), velocity_scale(actuator), tolerance),
                WavyFriction(contact(actuator, find(effects, effect_id<PositionDependentFriction>())),
                             wave(actuator, find(effects, effect_id<PositionDependentFriction>())), full_push(actuator),
                             velocity_scale(actuator), tolerance),
                SealFriction(contact(actuator, find(effects, effect_id<PistonFriction>())), full_push(actuator),
                             velocity_scale(actuator), tolerance),
                FlexiblePart(load.flexible, load.mass, actuator.stroke, velocity_scale(actuator)),
                StatelessTerms(actuator, load, effects)) {}

Effects::X Effects::set_load(const LoadParams& load, const X& x) noexcept {
  X carried = x;
  change<Friction>().set(load.friction);
  change<FlexiblePart>().set(load.flexible, load.mass);
  change<StatelessTerms>().set(load);
  carried[at<Friction>()] = get<Friction>().carried_over({x[at<Friction>()]})[0];
  return carried;
}

std::optional<LeanEffects> lean(const Effects& effects) noexcept {
  const std::optional<LandLeaks> leaks = effects.get<StatelessTerms>().as_land_leaks();
  const bool others = effects.get<Spool>().active() || effects.lines().active() || effects.get<Friction>().active() ||
                      effects.get<WavyFriction>().active() || effects.get<FlexiblePart>().active();
  if (!effects.active() || others || !leaks) {
    return std::nullopt;
  }
  return LeanEffects(effects.get<SupplyLine>(), effects.get<SealFriction>(), *leaks);
}

}  // namespace farrier::plant
