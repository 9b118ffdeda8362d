#pragma once

namespace farrier::plant {

/// Push of an end stop, F = s(ramp) (k depth + d depth'), s a smooth step over `ramp` 0..1: no kink at contact. Only
/// pushes, so that it never returns more than it took. depth > 0.
inline double stop_push(double depth, double approach_speed, double ramp, double stiffness, double damping) noexcept {
  const double engaged = ramp < 1.0 ? ramp * ramp * (3.0 - 2.0 * ramp) : 1.0;
  const double push = engaged * (stiffness * depth + damping * approach_speed);
  return push > 0.0 ? push : 0.0;
}

}  // namespace farrier::plant
