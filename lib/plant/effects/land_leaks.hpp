#pragma once

#include "plant/actuator.hpp"
#include "plant/effects/effect.hpp"
#include "plant/oil.hpp"
#include "plant/terms/valve_deadband.hpp"

namespace farrier::plant {

/// The present arguments of the terms of the oil.
inline OilMoment<double> oil_moment(const Instant& now, const ActuatorParams& actuator,
                                    double supply_flow_m3_s) noexcept {
  return {now.chamber_a_Pa,
          now.chamber_b_Pa,
          supply_flow_m3_s,
          hydraulic_force(actuator, now.chamber_a_Pa, now.chamber_b_Pa),
          actuator.bulk_modulus_Pa,
          actuator.supply_pressure_Pa - now.supply_fall_Pa,
          0.0,
          0.0,
          0.0,
          0.0,
          actuator.return_pressure_Pa,
          -0.0,
          -0.0};
}

/// Takes the leaks of their answer.
inline void take_leaks(const OilMoment<double>& oil, Instant& now) noexcept {
  now.into_a_m3_s = oil.into_a_m3_s;
  now.into_b_m3_s = oil.into_b_m3_s;
  now.past_lands_m3_s = oil.past_lands_m3_s;
  now.leakage_m3_s = oil.leakage_m3_s;
}

/// Adds the leaks that the terms of the oil gave to the chambers' inflow.
inline void add_leaks(Instant& now) noexcept {
  now.feed.past_a += now.into_a_m3_s - now.leakage_m3_s;
  now.feed.past_b += now.into_b_m3_s + now.leakage_m3_s;
}

/// Leaks of the valve's lands, by the code of their term, without those of other effects.
class LandLeaks : public Effect<0> {
 public:
  static constexpr bool kNeutralUnlessActive = true;

  LandLeaks(const ActuatorParams& actuator, const ValveDeadband<double>& lands) noexcept
      : actuator_(actuator), lands_(lands) {}

  bool active() const noexcept { return true; }
  void before_valve(Instant& now, const X&) const noexcept {
    OilMoment<double> oil = oil_moment(now, actuator_, 0.0);
    lands_.on_oil(oil);
    take_leaks(oil, now);
  }
  void after_valve(Instant& now, const X&, X&) const noexcept { add_leaks(now); }

 private:
  ActuatorParams actuator_;
  mutable ValveDeadband<double> lands_;  ///< mutable: hooks may change a term's state, but this has none
};

}  // namespace farrier::plant
