#pragma once

#include "plant/terms/term.hpp"

namespace farrier::plant {

/// A line of resistance R before the valve: its supply is p_s - R q with the flow q that the chambers draw, Merritt
/// (1967), 2-3. Neutral at 0.
template <class T>
class SupplyDroop {
 public:
  static constexpr std::array kParameters{
      Parameter{"resistance_Pa_s_m3", "resistance_Pa_s_m3", "Pa s/m^3", "Pa s/m^3", Scale::kDroop, false, 0.0, 5.0,
                {0.1, 0.8}, "Fall of the supply pressure per flow, R."}};
  static constexpr EffectInfo kInfo{"supply_droop", Side::kValveAndOil, false, false, kParameters,
                                    "The supply pressure falls with the flow that is drawn."};

  SupplyDroop(const T* fitted, const Scales& scales, double) noexcept
      : resistance_(fitted[0] * scales.of(Scale::kDroop)) {}

  void on_oil(OilMoment<T>& now) noexcept {
    const T fall = resistance_ * now.supply_flow_m3_s;
    now.supply_pressure_Pa -= fall < 0.9 * now.supply_pressure_Pa ? fall : T(0.9 * now.supply_pressure_Pa);
  }

  const T& resistance_Pa_s_m3() const noexcept { return resistance_; }

 private:
  T resistance_;
};

}  // namespace farrier::plant
