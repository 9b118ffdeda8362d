#pragma once

#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Hysteresis of torque motor and spool: the spool stands until the current is more than w from it, then follows at that
/// distance. It is the play operator of Krasnosel'skii and Pokrovskii (1989), exact for held currents. Neutral at 0.
template <class T>
class ValveHysteresis {
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
                                                    "Distance at which the spool follows the current, w."}};
  static constexpr EffectInfo kInfo{"valve_hysteresis",
                                    Side::kValveAndOil,
                                    false,
                                    false,
                                    kParameters,
                                    "The spool follows the current only after a half width.",
                                    true};

  ValveHysteresis(const T* fitted, const Scales& scales, double) noexcept
      : half_width_A_(fitted[0] * scales.of(Scale::kCurrent)) {}

  void on_valve(ValveMoment<T>& now) noexcept {
    if (spool_A_ > now.opening_A + half_width_A_) {
      spool_A_ = now.opening_A + half_width_A_;
    } else if (spool_A_ < now.opening_A - half_width_A_) {
      spool_A_ = now.opening_A - half_width_A_;
    }
    now.opening_A = spool_A_;
  }

  /// Puts the spool where a current without hysteresis would.
  void put(const T& current_A) noexcept { spool_A_ = current_A; }

 private:
  T half_width_A_;
  T spool_A_ = T(0.0);
};

}  // namespace farrier::plant
