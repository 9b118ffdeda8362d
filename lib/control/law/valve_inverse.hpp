#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "plant/terms/active_effect.hpp"

namespace farrier::control {

/// Currents by which a valve with overlap, ports of unlike size and a narrow port opens as an ideal one would. It
/// inverts plant::ValveDeadband, ValveAsymmetry and FlowSaturation in the reverse of the order in which they act. Odd
/// if the ports are alike.
///
/// The overlap d is crossed over `kCrossing` d of asked opening and not at once. A jump would turn the sign of the
/// smallest noise into 2 d of current, and a width found too large into a limit cycle. The rest of the overlap is a
/// dead zone of less than kCrossing d.
class ValveInverse {
 public:
  /// Share of the overlap over which it is crossed.
  static constexpr double kCrossing = 0.1;

  ValveInverse() = default;
  /// Takes those three of the effects. `current_max_A` > 0.
  ValveInverse(std::span<const plant::ActiveEffect> effects, double current_max_A) noexcept
      : current_max_A_(current_max_A) {
    using plant::effect_id;
    if (const auto* overlap = plant::find(effects, effect_id<plant::ValveDeadband>())) {
      overlap_A_ = overlap->values[0];
    }
    if (const auto* ports = plant::find(effects, effect_id<plant::ValveAsymmetry>())) {
      asymmetry_ = ports->values[0];
    }
    if (const auto* port = plant::find(effects, effect_id<plant::FlowSaturation>())) {
      inverse_saturation_1_A_ = 1.0 / port->values[0];
    }
  }

  /// `opening_A`: current at which an ideal valve would have the wanted opening. An opening beyond the valve's range,
  /// or beyond the current's limit, gives the largest current.
  double current_A(double opening_A) const noexcept {
    const double asked_A = opening_A / (opening_A > 0.0 ? 1.0 + asymmetry_ : 1.0 - asymmetry_);
    const double share = asked_A * inverse_saturation_1_A_;
    const double ports_A =
        share * share < 1.0 ? asked_A / std::sqrt(1.0 - share * share) : std::copysign(current_max_A_, asked_A);
    return std::clamp(ports_A + crossed(ports_A), -current_max_A_, current_max_A_);
  }

  /// The overlap from now on, A; >= 0.
  void set_overlap_A(double overlap_A) noexcept { overlap_A_ = overlap_A; }

 private:
  /// Current that moves the spool over its overlap: a cubic that ends level, (3 s - s^3) / 2.
  double crossed(double ports_A) const noexcept {
    if (!(overlap_A_ > 0.0)) {
      return 0.0;
    }
    const double s = std::clamp(ports_A / (kCrossing * overlap_A_), -1.0, 1.0);
    return 0.5 * overlap_A_ * s * (3.0 - s * s);
  }

  double current_max_A_ = 0.0;
  double overlap_A_ = 0.0;
  double asymmetry_ = 0.0;
  double inverse_saturation_1_A_ = 0.0;
};

}  // namespace farrier::control
