#pragma once

#include "plant/terms/term.hpp"

namespace farrier::plant {

/// An orifice in series with the port, as wide as the valve at the current u_s: q = K_v u sqrt(dp) / sqrt(1 + (u /
/// u_s)^2); two orifices in series, Merritt (1967), 3-4. Neutral where u_s is infinite.
template <class T>
class FlowSaturation {
 public:
  static constexpr std::array kParameters{
      Parameter{"saturation_current_A", "saturation_current_A", "A", "A", Scale::kCurrent, true, 1e-4, 200.0,
                {1.0, 4.0}, "Current at which valve and orifice are alike, u_s."}};
  static constexpr EffectInfo kInfo{"flow_saturation", Side::kValveAndOil, false, false, kParameters,
                                    "An orifice before the valve keeps its flow from growing with the current."};

  FlowSaturation(const T* fitted, const Scales& scales, double) noexcept
      : inverse_(fitted[0] / scales.of(Scale::kCurrent)) {}

  void on_valve(ValveMoment<T>& now) noexcept {
    using std::sqrt;
    const T share = now.opening_A * inverse_;
    now.opening_A /= sqrt(1.0 + share * share);
  }

 private:
  T inverse_;
};

}  // namespace farrier::plant
