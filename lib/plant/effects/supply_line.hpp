#pragma once

#include "plant/effects/effect.hpp"

namespace farrier::plant {

/// The accumulator of plant::SupplyDroop, integrated: the state is the fall of the valve's supply, Pa, which follows R q
/// with the time constant. Not active without a resistance and a time constant.
class SupplyLine : public Effect<1> {
 public:
  SupplyLine() = default;
  SupplyLine(double resistance_Pa_s_m3, double time_constant_s, double supply_pressure_Pa) noexcept
      : resistance_(resistance_Pa_s_m3), time_constant_s_(time_constant_s), supply_pressure_Pa_(supply_pressure_Pa) {}

  bool active() const noexcept { return resistance_ > 0.0 && time_constant_s_ > 0.0; }
  double fastest_rate(double) const noexcept { return 1.0 / time_constant_s_; }
  X scale() const noexcept { return {supply_pressure_Pa_}; }
  void before_valve(Instant& now, const X& x) const noexcept {
    constexpr double kMostShare = 0.9;  // as the term's
    const double most_Pa = kMostShare * supply_pressure_Pa_;
    now.supply_fall_Pa = x[0] < most_Pa ? x[0] : most_Pa;
  }
  void after_valve(Instant& now, const X& x, X& dx) const noexcept {
    // The chamber at the supply; nothing flows back into the line.
    const double flow = now.opening_A > 0.0 ? now.feed.flow_a / now.feed.root_a : now.feed.flow_b / now.feed.root_b;
    dx[0] = (resistance_ * (flow > 0.0 ? flow : 0.0) - x[0]) / time_constant_s_;
  }

 private:
  double resistance_ = 0.0;
  double time_constant_s_ = 0.0;
  double supply_pressure_Pa_ = 1.0;
};

}  // namespace farrier::plant
