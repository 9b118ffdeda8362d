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

  /// A spool that follows at once.
  ValveDynamics() = default;
  ValveDynamics(const T* fitted, const Scales&, double step_s) noexcept
      : ValveDynamics(1.0 / fitted[0], fitted[1], step_s) {}
  /// All > 0; the spool is moved by steps of `step_s`.
  ValveDynamics(T natural_frequency_rad_s, T damping, double step_s) noexcept {
    using portable::cos, portable::cosh, portable::exp, portable::sin, portable::sinh;
    using std::abs, std::sqrt;
    const T swing = natural_frequency_rad_s * step_s;
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

  void on_valve(ValveMoment<T>& now) noexcept { now.opening_A = move(now.opening_A); }
  /// Moves the spool for a step with that current, A. Returns its mean opening over the step, A, which acts on the oil.
  T move(T current_A) noexcept {
    const T error = opening_A_ - current_A;
    const T mean_A = current_A + (mean_by_error_ * error + mean_by_rate_ * rate_A_);
    opening_A_ = current_A + by_error_[0] * error + by_rate_[0] * rate_A_;
    rate_A_ = by_error_[1] * error + by_rate_[1] * rate_A_;
    return mean_A;
  }
  /// Current for which the spool is open now, A.
  T opening_A() const noexcept { return opening_A_; }
  /// Its rate over the natural frequency, A.
  T rate_A() const noexcept { return rate_A_; }
  /// Rests the spool where that current would hold it.
  void rest_at(T current_A) noexcept {
    opening_A_ = current_A;
    rate_A_ = T(0.0);
  }
  /// Coefficients of a step: {error, rate} after it per error (opening less current) and per rate (u_v' / w) before it.
  const std::array<T, 2>& by_error() const noexcept { return by_error_; }
  const std::array<T, 2>& by_rate() const noexcept { return by_rate_; }

 private:
  std::array<T, 2> by_error_{}, by_rate_{};
  T mean_by_error_ = T(0.0), mean_by_rate_ = T(0.0);
  T opening_A_ = T(0.0);
  T rate_A_ = T(0.0);  ///< u_v' / w
};

}  // namespace farrier::plant
