#pragma once

#include <array>

#include "plant/terms/valve_dynamics.hpp"

namespace farrier::control {

/// Speeds up a spool of second order, plant::ValveDynamics. The spool is simulated from the sent currents. The current
/// moves both of its sampled poles to one real place (Ackermann 1972), as near to zero as a bounded first jump of the
/// current allows. No measurement is fed back, so noise passes with that bound. A spool faster than that place is left
/// unchanged. Default: none.
class SpoolLead {
 public:
  /// Largest first jump of the current per jump of the input.
  static constexpr double kMostLead = 12.0;

  SpoolLead() = default;
  /// All > 0.
  SpoolLead(double natural_frequency_rad_s, double damping, double current_max_A, double period_s) noexcept;

  /// Current for the coming period, within +-current_max_A, at which the spool goes where `asked_A` wants it.
  double take(double asked_A) noexcept;
  /// Sets the spool to null.
  void reset() noexcept { spool_.rest_at(0.0); }

  /// Mean time by which the spool lags the input, in periods; 0 by default.
  double lag_ticks() const noexcept { return lag_ticks_; }

 private:
  double current_for(double asked_A) const noexcept;
  double find_lag_ticks() const noexcept;

  double current_max_A_ = 0.0;
  bool acts_ = false;
  plant::ValveDynamics<double> spool_;
  std::array<double, 2> gain_{};
  double lag_ticks_ = 0.0;
};

}  // namespace farrier::control
