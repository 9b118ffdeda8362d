#include "plant/effects/stateless_terms.hpp"

#include <algorithm>
#include <cmath>

#include "plant/oil.hpp"

namespace farrier::plant {

// Out of the integrator's loop, which is as fast as its code is short: most joints have none of these.

StatelessTerms::StatelessTerms(const ActuatorParams& actuator, const LoadParams& load,
                               std::span<const ActiveEffect> effects) noexcept
    : actuator_(actuator), load_(load) {
  const Scales scales(actuator, load);
  for (const ActiveEffect& effect : effects) {
    if (is_stateless(effect)) {
      add_to(terms_, effect, scales, 0.0);
      active_ = true;
    }
  }
  if (actuator.valve_deadband_A > 0.0 && find(effects, effect_id<ValveDeadband>()) == nullptr) {
    add_to(terms_, {effect_id<ValveDeadband>(), {actuator.valve_deadband_A}}, scales, 0.0);
    active_ = true;
  }
  hooks_ = terms_.hooks();
}

/// Flow that the chambers draw from a supply whose pressure falls with it: q = G sqrt(D - R q), D the drop from the
/// full supply to the port, G = K_v |u|. Nothing flows back into a line that droops. The drop's laminar range is left
/// out of this.
double StatelessTerms::supply_flow_m3_s(const Instant& now) const noexcept {
  const auto* droop = terms_.find<SupplyDroop>();
  const double drop = actuator_.supply_pressure_Pa - (now.opening_A > 0.0 ? now.valve_a_Pa : now.valve_b_Pa);
  const double gain = actuator_.valve_gain * now.flow_factor * std::abs(now.opening_A);
  if (droop == nullptr || !(drop > 0.0) || gain == 0.0) {
    return 0.0;
  }
  const double by_drop = gain * gain * drop;
  const double half = 0.5 * gain * gain * droop->resistance_Pa_s_m3();
  return by_drop / (half + std::sqrt(half * half + by_drop));
}

void StatelessTerms::act_on_valve(Instant& now) const noexcept {
  const ValveMoment<double> valve = opening(now.opening_A);
  now.opening_A = valve.opening_A;
  now.flow_factor = valve.flow_factor;
}

std::optional<LandLeaks> StatelessTerms::as_land_leaks() const noexcept {
  const auto* lands = terms_.find<ValveDeadband>();
  if (hooks_.piston > 0 || hooks_.load > 0 || hooks_.oil != (lands != nullptr ? 1 : 0)) {
    return std::nullopt;
  }
  constexpr std::array<double, kMostParameters> kNone{};
  return LandLeaks(actuator_,
                   lands != nullptr ? *lands : ValveDeadband<double>(kNone.data(), Scales(actuator_, load_), 0.0));
}

void StatelessTerms::act_on_oil(Instant& now) const noexcept {
  OilMoment<double> oil = oil_moment(now, actuator_, supply_flow_m3_s(now));
  terms_.on_oil(oil);
  take_leaks(oil, now);
  now.supply_fall_Pa = actuator_.supply_pressure_Pa - oil.supply_pressure_Pa;
  now.softness_a = oil.softness_a;
  now.softness_b = oil.softness_b;
  now.play_slope = oil.play_slope;
}

void StatelessTerms::act_on_forces(Instant& now) const noexcept {
  if (hooks_.piston > 0) {
    PistonMoment<double> piston{now.position, now.velocity, 0.0, 0.0};
    terms_.on_piston(piston);
    now.piston_force += piston.force;
  }
  if (hooks_.load == 0) {
    return;
  }
  LoadMoment<double> load{
      now.position, now.velocity, load_.mass, load_.damping, load_.stiffness, load_.equilibrium_position,
      0.0,          0.0,          0.0};
  terms_.on_load(load);
  now.load_force += load.external_force - load.hold - load.slope * now.velocity;
}

double StatelessTerms::force_at(double position, double velocity) const noexcept {
  Instant now{};
  X none{};
  now.position = position;
  now.velocity = velocity;
  after_valve(now, {}, none);
  return now.load_force + now.piston_force;
}

double StatelessTerms::fastest_rate(double mass) const noexcept {
  constexpr int kPlaces = 100;
  const double step = 1.02 * actuator_.stroke / kPlaces;
  const double slow = 1e-6 * velocity_scale(actuator_);
  double stiffness = 0.0;
  double damping = 0.0;
  double before = force_at(-0.01 * actuator_.stroke, 0.0);
  for (int i = 1; i <= kPlaces; ++i) {
    const double position = i * step - 0.01 * actuator_.stroke;
    const double force = force_at(position, 0.0);
    stiffness = std::max(stiffness, std::abs(force - before) / step);
    damping = std::max(damping, std::abs(force_at(position, slow) - force) / slow);
    before = force;
  }
  const double oil = actuator_.bulk_modulus_Pa / (actuator_.line_volume_m3 - valve_side_volume_m3(actuator_.line));
  OilMoment<double> leak{1.0, 0.0, 0.0, 0.0, actuator_.bulk_modulus_Pa, actuator_.supply_pressure_Pa,
                         0.0, 0.0, 0.0, 0.0};
  terms_.on_oil(leak);
  double filling = 0.0;
  for (const double sign : {-1.0, 1.0}) {
    ValveMoment<double> valve{sign * actuator_.valve_current_max_A, 1.0};
    terms_.on_valve(valve);
    filling = std::max(filling, valve.flow_factor * std::abs(valve.opening_A));
  }
  filling *= actuator_.valve_gain / std::sqrt(actuator_.laminar_pressure_Pa);
  OilMoment<double> lands{0.0, 0.0, 0.0, 0.0, actuator_.bulk_modulus_Pa, 1.0, 0.0, 0.0, 0.0, 0.0};
  terms_.on_oil(lands);
  const double leaking = 2.0 * (std::abs(leak.leakage_m3_s) + std::abs(lands.into_a_m3_s));
  return std::max(damping / mass + std::sqrt(stiffness / mass), oil * (filling + leaking));
}

}  // namespace farrier::plant
