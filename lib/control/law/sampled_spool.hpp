#pragma once

#include <array>

#include "plant/terms/valve_dynamics.hpp"

namespace farrier::control {

/// A valve's spool of second order, plant::ValveDynamics, simulated from the currents that are sent to it: exact for
/// currents that are held over a period. Default: a spool that follows at once.
class SampledSpool {
 public:
  SampledSpool() = default;
  /// Both > 0, as is `period_s`.
  SampledSpool(double natural_frequency_rad_s, double damping, double period_s) noexcept {
    const std::array<double, 2> fitted{1.0 / natural_frequency_rad_s, damping};
    const plant::ActuatorParams none{};
    const plant::ValveDynamics<double> spool(fitted.data(), plant::Scales(none, {}), period_s);
    by_error_ = spool.by_error();
    by_rate_ = spool.by_rate();
  }

  /// Moves the spool for a period with that current, A.
  void move(double current_A) noexcept {
    const double error = place_A_ - current_A;
    place_A_ = current_A + by_error_[0] * error + by_rate_[0] * rate_A_;
    rate_A_ = by_error_[1] * error + by_rate_[1] * rate_A_;
  }
  /// Current for which the spool is open now, A.
  double place_A() const noexcept { return place_A_; }
  /// Its rate over the natural frequency, A.
  double rate_A() const noexcept { return rate_A_; }
  /// Parts of the error (place less current) and of the rate that are left after a period: of the place, of the rate.
  const std::array<double, 2>& by_error() const noexcept { return by_error_; }
  const std::array<double, 2>& by_rate() const noexcept { return by_rate_; }
  /// Rests the spool where that current would hold it.
  void rest_at(double current_A) noexcept {
    place_A_ = current_A;
    rate_A_ = 0.0;
  }

 private:
  std::array<double, 2> by_error_{}, by_rate_{};
  double place_A_ = 0.0, rate_A_ = 0.0;
};

}  // namespace farrier::control
