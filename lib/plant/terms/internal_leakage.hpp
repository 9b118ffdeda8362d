#pragma once

#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Laminar flow past the piston, Merritt (1967), 6.1: c (p_a - p_b) from a to b. Neutral at 0.
template <class T>
class InternalLeakage {
 public:
  static constexpr std::array kParameters{
      Parameter{"coefficient_m3_s_Pa", "coefficient_m3_s_Pa", "m^3/s/Pa", "m^3/s/Pa", Scale::kLeakage, false, 0.0,
                0.5, {0.005, 0.03}, "Flow per difference of pressure, c."}};
  static constexpr EffectInfo kInfo{"internal_leakage", Side::kValveAndOil, false, false, kParameters,
                                    "Oil leaks past the piston from one chamber to the other."};

  InternalLeakage(const T* fitted, const Scales& scales, double) noexcept
      : coefficient_(fitted[0] * scales.of(Scale::kLeakage)) {}

  void on_oil(OilMoment<T>& now) noexcept {
    now.leakage_m3_s += coefficient_ * (now.pressure_a_Pa - now.pressure_b_Pa);
  }

 private:
  T coefficient_;
};

}  // namespace farrier::plant
