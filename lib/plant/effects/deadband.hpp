#pragma once

#include "plant/effects/effect.hpp"
#include "plant/refusals.hpp"

namespace farrier::plant {

inline Result<Done> validate_deadband(double half_width_A, double current_max_A) {
  Refusals refusals("valve");
  refusals.require(half_width_A >= 0.0 && half_width_A < current_max_A, "deadband_A", half_width_A,
                   "finite, >= 0 and < valve_current_max_A");
  return refusals.verdict();
}

/// Overlap of the spool, Hubacher (2014), 9.3.4; Merritt (1967), 5.2: lands wider than the ports by what a current of d
/// moves the spool. The valve opens by 0 for |u_v| <= d, by u_v - d beyond and u_v + d below. Neutral at d = 0.
class Deadband : public Effect<0> {
 public:
  explicit Deadband(double half_width_A) noexcept : half_width_A_(half_width_A) {}

  bool active() const noexcept { return half_width_A_ > 0.0; }
  void before_valve(Instant& now, const X&) const noexcept {
    if (now.opening_A > half_width_A_) {
      now.opening_A -= half_width_A_;
    } else if (now.opening_A < -half_width_A_) {
      now.opening_A += half_width_A_;
    } else {
      now.opening_A = 0.0;
    }
  }

 private:
  double half_width_A_;
};

}  // namespace farrier::plant
