#pragma once

#include <type_traits>

namespace farrier::diagnosis {

/// Constants of a joint that a fit may move within 3 %; SI, actuator coordinates, as in plant::ActuatorParams.
template <class T>
struct Constants {
  T area_a, area_b, line_volume_m3, bulk_modulus_Pa, valve_gain, supply_pressure_Pa, piston_mass, piston_damping;
  T mass, damping, stiffness;
  double slack_position, stroke, return_pressure_Pa, laminar_pressure_Pa, current_max_A;
};

template <class T>
double value_of(const T& number) noexcept {
  if constexpr (requires { number.a; }) {
    return number.a;
  } else {
    return number;
  }
}

/// A function of x and y for its value and both partial derivatives there.
template <class T>
T chained(double value, double by_x, const T& x, double by_y, const T& y) {
  if constexpr (std::is_same_v<T, double>) {
    return value;
  } else {
    return T(value, by_x * x.v + by_y * y.v);
  }
}

}  // namespace farrier::diagnosis
