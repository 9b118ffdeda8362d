#pragma once

#include <algorithm>
#include <cmath>

#include "control/law/force_controller.hpp"
#include "plant/actuator.hpp"

namespace farrier::control {

/// Opening at which a valve behind a line of resistance R, plant::SupplyDroop, passes the same flow as from a stiff
/// supply. D is the drop of both ports together for the sign of the opening, Hubacher (2014) (3.23), and q the flow
/// wanted from the supply. Then u' = u / sqrt(1 - R q / D); for u < 0 the load feels alpha of the fall. Default: none.
class DroopInverse {
 public:
  /// Largest u' / u: beyond it the estimate of the fallen supply is too inaccurate.
  static constexpr double kMostGain = 3.0;

  DroopInverse() = default;
  /// `resistance_Pa_s_m3` >= 0; `actuator` passes plant::validate.
  DroopInverse(double resistance_Pa_s_m3, const plant::ActuatorParams& actuator) noexcept
      : resistance_Pa_s_m3_(resistance_Pa_s_m3),
        area_(actuator.area_a),
        alpha_(actuator.area_b / actuator.area_a),
        piston_damping_(actuator.piston_damping),
        supply_Pa_(actuator.supply_pressure_Pa),
        return_Pa_(actuator.return_pressure_Pa),
        laminar_Pa_(actuator.laminar_pressure_Pa),
        valve_gain_(actuator.valve_gain / std::sqrt(1.0 + alpha_ * alpha_ * alpha_)) {}

  double opening_A(double asked_A, const Measurement& measured) const noexcept {
    if (resistance_Pa_s_m3_ == 0.0) {
      return asked_A;
    }
    const double load_Pa = (measured.force + piston_damping_ * measured.velocity) / area_;  // (2.22)
    const double drop_Pa = std::max(laminar_Pa_, asked_A > 0.0 ? supply_Pa_ - load_Pa - alpha_ * return_Pa_
                                                               : alpha_ * supply_Pa_ + load_Pa - return_Pa_);
    const double flow_a_m3_s = valve_gain_ * std::abs(asked_A) * std::sqrt(drop_Pa);
    const double felt = asked_A > 0.0 ? 1.0 : alpha_ * alpha_;  // share alpha of the flow, alpha of the fall
    const double left = 1.0 - felt * resistance_Pa_s_m3_ * flow_a_m3_s / drop_Pa;
    return asked_A / std::sqrt(std::max(left, 1.0 / (kMostGain * kMostGain)));
  }

 private:
  double resistance_Pa_s_m3_ = 0.0;
  double area_ = 1.0;
  double alpha_ = 1.0;
  double piston_damping_ = 0.0;
  double supply_Pa_ = 0.0;
  double return_Pa_ = 0.0;
  double laminar_Pa_ = 0.0;
  double valve_gain_ = 0.0;  ///< K_v / sqrt(1 + alpha^3), (3.33)
};

}  // namespace farrier::control
