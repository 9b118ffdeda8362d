#pragma once

#include "core/portable_math.hpp"
#include "plant/terms/term.hpp"

namespace farrier::plant {

/// A line of resistance R before the valve, behind it an accumulator: the supply falls towards R q, q the flow that the
/// chambers draw, with a time constant; Merritt (1967), 2-3. Neutral at 0.
template <class T>
class SupplyDroop {
 public:
  static constexpr std::array kParameters{
      Parameter{"resistance_Pa_s_m3",
                "resistance_Pa_s_m3",
                "Pa s/m^3",
                "Pa s/m^3",
                Scale::kDroop,
                false,
                0.0,
                50.0,
                {0.1, 0.8},
                "Fall of the supply pressure per flow, R."},
      Parameter{"time_constant_s",
                "time_constant_s",
                "s",
                "s",
                Scale::kSecond,
                false,
                0.0,
                1.0,
                {0.0, 0.0},
                "Time constant of line and accumulator; 0: the fall follows the flow at once.",
                true}};
  static constexpr EffectInfo kInfo{"supply_droop", Side::kValveAndOil,
                                    false,          false,
                                    kParameters,    "The supply pressure falls with the flow that is drawn."};

  SupplyDroop(const T* fitted, const Scales& scales, double step_s) noexcept
      : resistance_(fitted[0] * scales.of(Scale::kDroop)), lags_(fitted[1] > 0.0) {
    using portable::exp;
    follows_ = lags_ ? T(1.0 - exp(T(-step_s / fitted[1]))) : T(1.0);
  }

  void on_oil(OilMoment<T>& now) noexcept {
    fall_ += follows_ * (resistance_ * now.supply_flow_m3_s - fall_);
    now.supply_pressure_Pa -= fall_ < 0.9 * now.supply_pressure_Pa ? fall_ : T(0.9 * now.supply_pressure_Pa);
  }

  const T& resistance_Pa_s_m3() const noexcept { return resistance_; }

 private:
  T resistance_;
  bool lags_;
  T follows_;
  T fall_ = T(0.0);
};

}  // namespace farrier::plant
