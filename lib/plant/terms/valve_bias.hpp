#pragma once

#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Null shift of the valve, Merritt (1967), 6.3: the ports are shut at current -b. Neutral at 0.
template <class T>
class ValveBias {
 public:
  static constexpr std::array kParameters{
      Parameter{"current_A", "current_A", "A", "A", Scale::kCurrent, false, -0.3, 0.3, {0.002, 0.002},
                "Added to the current."}};
  static constexpr EffectInfo kInfo{"valve_bias", Side::kValveAndOil, false, true, kParameters,
                                    "The valve is shut at another current than 0."};

  ValveBias(const T* fitted, const Scales& scales, double) noexcept
      : current_A_(fitted[0] * scales.of(Scale::kCurrent)) {}

  void on_valve(ValveMoment<T>& now) noexcept { now.opening_A += current_A_; }

 private:
  T current_A_;
};

}  // namespace farrier::plant
