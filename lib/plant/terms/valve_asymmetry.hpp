#pragma once

#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Ports of unlike size: the valve gain is K_v (1 + r) where the ports extend and K_v (1 - r) where they retract;
/// Merritt (1967), 5.6 (unmatched orifices). Neutral at 0.
template <class T>
class ValveAsymmetry {
 public:
  static constexpr std::array kParameters{
      Parameter{"ratio", "ratio", "1", "1", Scale::kOne, false, -0.7, 0.7, {0.02, 0.02},
                "Share r by which the gain differs."}};
  static constexpr EffectInfo kInfo{"valve_asymmetry", Side::kValveAndOil, false, true, kParameters,
                                    "The ports that extend are larger than those that retract, or smaller."};

  ValveAsymmetry(const T* fitted, const Scales&, double) noexcept : ratio_(fitted[0]) {}

  void on_valve(ValveMoment<T>& now) noexcept {
    now.flow_factor *= now.opening_A > 0.0 ? T(1.0 + ratio_) : T(1.0 - ratio_);
  }

 private:
  T ratio_;
};

}  // namespace farrier::plant
