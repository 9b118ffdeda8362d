#pragma once

#include <optional>
#include <span>

#include "plant/actuator.hpp"
#include "plant/effects/effect.hpp"
#include "plant/effects/land_leaks.hpp"
#include "plant/terms/load_effects.hpp"

namespace farrier::plant {

/// True if an effect is part of the plant and its term's own code simulates it: all but those of sensors, those in the
/// load's parameters and those with a state. A supply that droops has one (SupplyLine) with a time constant.
inline bool is_stateless(const ActiveEffect& effect) noexcept {
  const EffectId id = effect.id;
  const Side side = effect_info(id).side;
  return (side == Side::kValveAndOil || side == Side::kLoad) && !is_in_load(id) && !effect_info(id).has_state &&
         !(id == effect_id<SupplyDroop>() && *parameter_value(effect, "time_constant_s") > 0.0);
}

/// All stateless effects of a joint, by the code of their terms. It stands last in Effects: after spool and lines have
/// set the valve's opening and the pressures at it. A null shift then acts behind the spool, which gives the same
/// result: the shift is constant from the start.
class StatelessTerms : public Effect<0> {
 public:
  StatelessTerms(const ActuatorParams& actuator, const LoadParams& load,
                 std::span<const ActiveEffect> effects) noexcept;

  void set(const LoadParams& load) noexcept { load_ = load; }

  bool active() const noexcept { return active_; }
  /// Those on oil, piston and load, if they are the valve's lands alone.
  std::optional<LandLeaks> as_land_leaks() const noexcept;
  /// Fastest rate of springs and dampers on load and piston, of the valve at its largest current and of a leak.
  double fastest_rate(double mass) const noexcept;
  /// The opening of the valve under a current, with the factor on the valve gain.
  ValveMoment<double> opening(double current_A) const noexcept {
    ValveMoment<double> valve{current_A, 1.0};
    if (hooks_.valve > 0) {
      terms_.on_valve(valve);
    }
    return valve;
  }
  void before_valve(Instant& now, const X&) const noexcept {
    if (hooks_.valve > 0) {
      act_on_valve(now);
    }
    if (hooks_.oil > 0) {
      act_on_oil(now);
    }
  }
  void after_valve(Instant& now, const X&, X&) const noexcept {
    if (hooks_.oil > 0) {
      add_leaks(now);
    }
    if (hooks_.piston > 0 || hooks_.load > 0) {
      act_on_forces(now);
    }
  }

 private:
  void act_on_valve(Instant& now) const noexcept;
  void act_on_oil(Instant& now) const noexcept;
  void act_on_forces(Instant& now) const noexcept;
  double supply_flow_m3_s(const Instant& now) const noexcept;
  double force_at(double position, double velocity) const noexcept;

  mutable TermSet<double> terms_;  ///< mutable: hooks may change a term's state, but these have none
  TermSet<double>::Hooks hooks_;   ///< those without a term are skipped
  bool active_ = false;
  ActuatorParams actuator_;
  LoadParams load_;
};

}  // namespace farrier::plant
