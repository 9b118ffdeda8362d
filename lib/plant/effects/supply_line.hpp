#pragma once

#include "plant/effects/effect.hpp"

namespace farrier::plant {

/// The accumulator of plant::SupplyDroop, integrated: the state is the fall of the valve's supply, Pa, which follows R q
/// with the time constant. Not active without a resistance and a time constant.
class SupplyLine : public Effect<1> {
 public:
  static constexpr bool kNeutralUnlessActive = true;

  SupplyLine() = default;
  SupplyLine(double resistance_Pa_s_m3, double time_constant_s, double supply_pressure_Pa) noexcept
      : active_(resistance_Pa_s_m3 > 0.0 && time_constant_s > 0.0),
        resistance_(active_ ? resistance_Pa_s_m3 : 0.0),
        rate_1_s_(active_ ? 1.0 / time_constant_s : 1.0),
        supply_pressure_Pa_(supply_pressure_Pa) {}

  bool active() const noexcept { return active_; }
  double fastest_rate(double) const noexcept { return rate_1_s_; }
  X scale() const noexcept { return {supply_pressure_Pa_}; }
  void before_valve(Instant& now, const X& x) const noexcept {
    constexpr double kMostShare = 0.9;  // as the term's
    const double most_Pa = kMostShare * supply_pressure_Pa_;
    now.supply_fall_Pa = x[0] < most_Pa ? x[0] : most_Pa;
  }
  void after_valve(Instant& now, const X& x, X& dx) const noexcept {
    // The chamber at the supply; nothing flows back into the line.
    const bool extends = now.opening_A > 0.0;
    const double flow = (extends ? now.feed.flow_a : now.feed.flow_b) / (extends ? now.feed.root_a : now.feed.root_b);
    dx[0] = rate_1_s_ * (resistance_ * (flow > 0.0 ? flow : 0.0) - x[0]);
  }

 private:
  bool active_ = false;
  double resistance_ = 0.0;
  double rate_1_s_ = 1.0;
  double supply_pressure_Pa_ = 1.0;
};

}  // namespace farrier::plant
