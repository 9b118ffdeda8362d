#pragma once

#include <utility>

#include "diagnosis/model/drive_numbers.hpp"
#include "diagnosis/model/load_simulation.hpp"

namespace farrier::diagnosis {

/// The nominal load of an electric joint with a model's factors.
template <class T>
struct LoadNumbers {
  T mass, damping, stiffness;
  double slack_position;
};

/// All on a rotor but its gear over a step of its mean speed w, with its inertia: push - resists w.
template <class T>
struct RotorStep {
  T push, resists;
};

/// Mean speeds of rotor and load over a step of `h` s, the load from position x and speed v. The gear joins them. The
/// rotor's mean speed is w = a + b v of the load's, which then sees a damper to a moved base.
template <class T>
std::pair<T, T> mean_speeds(plant::LoadMoment<T> load, const RotorStep<T>& rotor, const GearStep<T>& gear, const T& x,
                            const T& v, double h) {
  const T along = 1.0 / (rotor.resists + gear.slope);
  const T a = (rotor.push - gear.base) * along;
  const T b = gear.slope * along;
  load.damping += gear.slope * (1.0 - b);
  const T mean = mean_speed(load, x, v, T(gear.base + gear.slope * a), h);
  return {a + b * mean, mean};
}

}  // namespace farrier::diagnosis
