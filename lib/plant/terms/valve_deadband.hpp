#pragma once

#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Overlap of the spool, Hubacher (2014), 9.3.4; Merritt (1967), 5.2: the ports open by what the current exceeds d.
/// Neutral at 0.
template <class T>
class ValveDeadband {
 public:
  static constexpr std::array kParameters{
      Parameter{"half_width_A", "half_width_A", "A", "A", Scale::kCurrent, false, 0.0, 0.4, {0.01, 0.05},
                "Current that moves the spool over its overlap."}};
  static constexpr EffectInfo kInfo{"valve_deadband", Side::kValveAndOil, false, false, kParameters,
                                    "The spool overlaps its ports: small currents open nothing."};

  ValveDeadband(const T* fitted, const Scales& scales, double) noexcept
      : half_width_A_(fitted[0] * scales.of(Scale::kCurrent)) {}

  void on_valve(ValveMoment<T>& now) noexcept {
    if (now.opening_A > half_width_A_) {
      now.opening_A -= half_width_A_;
    } else if (now.opening_A < -half_width_A_) {
      now.opening_A += half_width_A_;
    } else {
      now.opening_A = T(0.0);
    }
  }

 private:
  T half_width_A_;
};

}  // namespace farrier::plant
