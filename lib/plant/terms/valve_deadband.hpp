#pragma once

#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Overlap of the spool, Hubacher (2014), 9.3.4; Merritt (1967), 5.2: the ports open by what the current exceeds d.
/// Each of the four lands leaks in laminar flow of conductance k: into a chamber k (p_s - p) - k (p - p_t). Neutral at
/// 0.
template <class T>
class ValveDeadband {
 public:
  static constexpr std::array kParameters{Parameter{"half_width_A",
                                                    "half_width_A",
                                                    "A",
                                                    "A",
                                                    Scale::kCurrent,
                                                    false,
                                                    0.0,
                                                    0.4,
                                                    {0.01, 0.05},
                                                    "Current that moves the spool over its overlap."},
                                          Parameter{"leakage_m3_s_Pa",
                                                    "leakage_m3_s_Pa",
                                                    "m^3/s/Pa",
                                                    "m^3/s/Pa",
                                                    Scale::kLeakage,
                                                    false,
                                                    0.0,
                                                    0.1,
                                                    {0.0, 0.0},
                                                    "Flow per difference of pressure past each of its four lands, k.",
                                                    true}};
  static constexpr EffectInfo kInfo{"valve_deadband",
                                    Side::kValveAndOil,
                                    false,
                                    false,
                                    kParameters,
                                    "The spool overlaps its ports: small currents open nothing."};

  ValveDeadband(const T* fitted, const Scales& scales, double) noexcept
      : half_width_A_(fitted[0] * scales.of(Scale::kCurrent)), leakage_(fitted[1] * scales.of(Scale::kLeakage)) {}

  void on_valve(ValveMoment<T>& now) noexcept {
    if (now.opening_A > half_width_A_) {
      now.opening_A -= half_width_A_;
    } else if (now.opening_A < -half_width_A_) {
      now.opening_A += half_width_A_;
    } else {
      now.opening_A = T(0.0);
    }
  }

  void on_oil(OilMoment<T>& now) noexcept {
    const T ports_Pa = now.supply_pressure_Pa + now.return_pressure_Pa;
    now.into_a_m3_s += leakage_ * (ports_Pa - 2.0 * now.pressure_a_Pa);
    now.into_b_m3_s += leakage_ * (ports_Pa - 2.0 * now.pressure_b_Pa);
    now.past_lands_m3_s += leakage_ * (2.0 * now.supply_pressure_Pa - now.pressure_a_Pa - now.pressure_b_Pa);
  }

 private:
  T half_width_A_, leakage_;
};

}  // namespace farrier::plant
