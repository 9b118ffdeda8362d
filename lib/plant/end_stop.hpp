#pragma once

namespace farrier::plant {

/// Share by which a stop is engaged: a smooth step over `ramp` 0..1.
inline double stop_engaged(double ramp) noexcept { return ramp < 1.0 ? ramp * ramp * (3.0 - 2.0 * ramp) : 1.0; }

/// Push of an end stop, F = s(ramp) (k depth + d depth'), s a smooth step over `ramp` 0..1: no kink at contact. Only
/// pushes, so that it never returns more than it took. depth > 0.
inline double stop_push(double depth, double approach_speed, double ramp, double stiffness, double damping) noexcept {
  const double engaged = stop_engaged(ramp);
  const double push = engaged * (stiffness * depth + damping * approach_speed);
  return push > 0.0 ? push : 0.0;
}

/// The same with its derivatives by depth and speed; `steepness` is d(ramp)/d(depth), 1/m or 1/rad.
struct StopPush {
  double force = 0.0, by_depth = 0.0, by_speed = 0.0;
};
inline StopPush stop_push_and_slopes(double depth, double approach_speed, double steepness, double stiffness,
                                     double damping) noexcept {
  const double ramp = depth * steepness;
  const double engaged = stop_engaged(ramp);
  const double slope = ramp < 1.0 ? 6.0 * ramp * (1.0 - ramp) * steepness : 0.0;
  const double full = stiffness * depth + damping * approach_speed;
  if (!(full > 0.0)) {
    return {};
  }
  return {engaged * full, slope * full + engaged * stiffness, engaged * damping};
}

}  // namespace farrier::plant
