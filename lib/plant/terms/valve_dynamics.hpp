#pragma once

#include "core/portable_math.hpp"
#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Spool of second order, Hubacher (2014), (2.18), (2.19): u_v'' / w^2 + 2 D u_v' / w + u_v = u, exact for a current
/// held over a substep. Neutral where w is infinite.
template <class T>
class ValveDynamics {
 public:
  static constexpr std::array kParameters{
      Parameter{"natural_frequency_rad_s",
                "natural_frequency_rad_s",
                "rad/s",
                "rad/s",
                Scale::kRate,
                true,
                1e-5,
                0.03,
                {0.001, 0.004},
                "Natural frequency of the spool, w."},
      Parameter{"damping", "damping", "1", "1", Scale::kOne, false, 0.3, 1.5, {0.7, 0.7}, "Its damping, D."}};
  static constexpr EffectInfo kInfo{"valve_dynamics",
                                    Side::kValveAndOil,
                                    false,
                                    false,
                                    kParameters,
                                    "The spool follows the current as a mass on a spring does.",
                                    true};

  ValveDynamics(const T* fitted, const Scales&, double step_s) noexcept {
    using portable::cos, portable::cosh, portable::exp, portable::sin, portable::sinh;
    using std::abs, std::sqrt;
    const T swing = step_s / fitted[0];  // w h
    const T damping = fitted[1];
    const T decay = exp(-damping * swing);
    const T square = 1.0 - damping * damping;
    const T split = sqrt(abs(square) + 1e-12) * swing;
    const bool swings = square > 0.0;
    // sin(split) / (split / swing), cos(split), or their hyperbolic counterparts.
    const T sine = decay * (swings ? T(sin(split)) : T(sinh(split))) * swing / split;
    const T cosine = decay * (swings ? T(cos(split)) : T(cosh(split)));
    by_error_ = {cosine + damping * sine, -sine};
    by_rate_ = {sine, cosine - damping * sine};
    // The spool's equation, integrated over the substep.
    mean_by_error_ = -(by_error_[1] + 2.0 * damping * (by_error_[0] - 1.0)) / swing;
    mean_by_rate_ = -(by_rate_[1] - 1.0 + 2.0 * damping * by_rate_[0]) / swing;
  }

  void on_valve(ValveMoment<T>& now) noexcept {
    const T error = opening_A_ - now.opening_A;
    opening_A_ = now.opening_A + by_error_[0] * error + by_rate_[0] * rate_A_;
    // The mean opening acts over the substep.
    now.opening_A += mean_by_error_ * error + mean_by_rate_ * rate_A_;
    rate_A_ = by_error_[1] * error + by_rate_[1] * rate_A_;
  }
  /// Coefficients of a step: {error, rate} after it per error (opening less current) and per rate (u_v' / w) before it.
  const std::array<T, 2>& by_error() const noexcept { return by_error_; }
  const std::array<T, 2>& by_rate() const noexcept { return by_rate_; }

 private:
  std::array<T, 2> by_error_, by_rate_;
  T mean_by_error_, mean_by_rate_;
  T opening_A_ = T(0.0);
  T rate_A_ = T(0.0);  ///< u_v' / w
};

}  // namespace farrier::plant
