#include "plant/terms/load_effects.hpp"

namespace farrier::plant {
namespace {

/// `stance` changed as the swing load is, from `was` to `now`; where both loads are alike they stay so to the last bit.
double shifted(double stance, double was, double now) noexcept { return stance == was ? now : stance + (now - was); }

}  // namespace

Loads loads_with_effects(const Loads& nominal, const Scales& scales, std::span<const ActiveEffect> effects) {
  const LoadParams& was = nominal.swing;
  TermSet<double> terms;
  bool changed = false;
  for (const ActiveEffect& effect : effects) {
    if (is_in_load(effect.id)) {
      add_to(terms, effect, scales, 0.0);
      changed = true;
    }
  }
  if (!changed) {
    return nominal;
  }
  LoadMoment<double> now{0.0, 0.0, was.mass, was.damping, was.stiffness, was.equilibrium_position, 0.0, 0.0, 0.0};
  terms.on_load(now);

  Loads loads = nominal;
  loads.swing.mass = now.mass;
  loads.swing.damping = now.damping;
  loads.swing.stiffness = now.stiffness;
  loads.swing.equilibrium_position = now.slack_position;
  LoadParams& stance = loads.stance;
  const bool same_slack = stance.equilibrium_position == was.equilibrium_position;
  const bool same_spring = stance.stiffness == was.stiffness && (same_slack || was.stiffness == 0.0);
  // C_s' = C_s + C - C_n, C_s' x_s' = C_s x_s + C x - C_n x_n: the stance spring gets the same force beside its own.
  const double pull = stance.stiffness * stance.equilibrium_position + now.stiffness * now.slack_position -
                      was.stiffness * was.equilibrium_position;
  stance.mass = shifted(stance.mass, was.mass, now.mass);
  stance.damping = shifted(stance.damping, was.damping, now.damping);
  stance.stiffness = shifted(stance.stiffness, was.stiffness, now.stiffness);
  if (same_spring) {
    stance.equilibrium_position = now.slack_position;
  } else if (stance.stiffness > 0.0) {
    stance.equilibrium_position = pull / stance.stiffness;
  }
  return loads;
}

}  // namespace farrier::plant
