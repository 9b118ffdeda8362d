#pragma once

#include <array>

namespace farrier::control {

/// Makes a spool of second order, plant::ValveDynamics, follow sooner than it does by itself: the spool is carried
/// along from the currents that were sent, and the current is asked for with which both of its sampled poles move to
/// one real place (Ackermann 1972), as near to zero as a bounded first jump of the current allows. It feeds nothing
/// measured back, so noise passes with that bound. A spool faster than that place is left alone. Default: none.
class SpoolLead {
 public:
  /// Largest first jump of the current per jump of what is asked for.
  static constexpr double kMostLead = 12.0;

  SpoolLead() = default;
  /// All > 0.
  SpoolLead(double natural_frequency_rad_s, double damping, double current_max_A, double period_s) noexcept;

  /// Current for the coming period, within +-current_max_A, at which the spool goes where `asked_A` wants it.
  double take(double asked_A) noexcept;
  /// The spool stands at null.
  void reset() noexcept { spool_A_ = {}; }

  /// Mean time by which the spool stays behind what is asked for, in periods; 0 by default.
  double lag_ticks() const noexcept { return lag_ticks_; }

 private:
  double find_lag_ticks() const noexcept;
  std::array<double, 2> moved(double current_A) const noexcept;

  double current_max_A_ = 0.0;
  bool acts_ = false;
  std::array<double, 2> by_error_{}, by_rate_{};  ///< of the spool over a period, about the current
  std::array<double, 2> gain_{};
  std::array<double, 2> spool_A_{};               ///< place, rate / w
  double lag_ticks_ = 0.0;
};

}  // namespace farrier::control
