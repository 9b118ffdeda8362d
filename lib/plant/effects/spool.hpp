#pragma once

#include <algorithm>

#include "plant/effects/effect.hpp"
#include "plant/refusals.hpp"

namespace farrier::plant {

/// Dynamics of the valve's spool; off, the spool follows its command at once.
struct SpoolParams {
  bool on = false;
  double natural_frequency_rad_s = 1570.0;  ///< omega_v; > 0
  double damping = 0.5;                     ///< D_v; > 0
};

inline Result<Done> validate(const SpoolParams& spool) {
  Refusals refusals("spool");
  refusals.positive("natural_frequency_rad_s", spool.natural_frequency_rad_s);
  refusals.positive("damping", spool.damping);
  return refusals.verdict();
}

/// The equation of plant::ValveDynamics, integrated: states u_v (A) and u_v' / omega_v (A). The ports are full open at
/// the valve's largest current, wherever the spool overshoots to.
class Spool : public Effect<2> {
 public:
  Spool(const SpoolParams& params, double current_max_A) noexcept : params_(params), current_max_A_(current_max_A) {}

  bool active() const noexcept { return params_.on; }
  double fastest_rate(double) const noexcept {
    // Modulus of the fastest pole: omega_v (D_v + sqrt(D_v^2 - 1)), at most 2 D_v omega_v, or omega_v when they swing.
    return params_.natural_frequency_rad_s * std::max(1.0, 2.0 * params_.damping);
  }
  X scale() const noexcept { return {current_max_A_, current_max_A_}; }
  void before_valve(Instant& now, const X& x) const noexcept {
    now.opening_A = std::clamp(x[0], -current_max_A_, current_max_A_);
  }
  void after_valve(Instant& now, const X& x, X& dx) const noexcept {
    const double omega = params_.natural_frequency_rad_s;
    dx[0] = omega * x[1];
    dx[1] = omega * (now.command_A - x[0] - 2.0 * params_.damping * x[1]);
  }

 private:
  SpoolParams params_;
  double current_max_A_;
};

}  // namespace farrier::plant
