#include "robot/wear.hpp"

#include "robot/joint_model.hpp"

namespace farrier::robot {
namespace {

/// The effect of the joint; a neutral one is added if there is none.
plant::ActiveEffect& effect_of(Joint& joint, plant::EffectId id) {
  for (plant::ActiveEffect& effect : joint.effects) {
    if (effect.id == id) {
      return effect;
    }
  }
  return joint.effects.emplace_back(plant::ActiveEffect{.id = id});
}

double between(double from, double to, double share) noexcept { return from + share * (to - from); }

}  // namespace

Wear no_wear(const Joint& joint) noexcept { return {.overlap_A = nominal_physics(joint, joint.stance_load).overlap_A}; }

Joint worn(const Joint& joint, const Wear& wear) {
  Joint made = joint;
  made.actuator.valve_gain *= wear.valve_gain;
  made.actuator.bulk_modulus_Pa *= wear.bulk_modulus;
  made.actuator.piston_damping *= wear.viscosity;
  if (wear.overlap_A != no_wear(joint).overlap_A) {
    effect_of(made, plant::effect_id<plant::ValveDeadband>()).values[0] = wear.overlap_A;
  }
  if (wear.leakage > 0.0) {
    effect_of(made, plant::effect_id<plant::InternalLeakage>()).values[0] += wear.leakage;
  }
  for (plant::ActiveEffect& effect : made.effects) {
    if (effect.id == plant::effect_id<plant::PistonFriction>()) {
      effect.values[0] *= wear.seal_friction;
    }
  }
  return made;
}

Wear between(const Wear& from, const Wear& to, double share) noexcept {
  return {.valve_gain = between(from.valve_gain, to.valve_gain, share),
          .bulk_modulus = between(from.bulk_modulus, to.bulk_modulus, share),
          .viscosity = between(from.viscosity, to.viscosity, share),
          .seal_friction = between(from.seal_friction, to.seal_friction, share),
          .leakage = between(from.leakage, to.leakage, share),
          .overlap_A = between(from.overlap_A, to.overlap_A, share),
          .stuck_A = to.stuck_A};
}

}  // namespace farrier::robot
