#pragma once

// A second route through a tick.

namespace farrier::plant::test {

/// A tick of `period_s` by the classical fourth-order method in steps of a five-hundredth, 2 us of a millisecond: kept
/// apart from the integrator under test.
template <class Equations, class Input, class State>
State reference_tick(const Equations& f, const Input& in, State s, double period_s) {
  constexpr int kSubsteps = 500;
  const double h = period_s / kSubsteps;
  for (int i = 0; i < kSubsteps; ++i) {
    const auto k1 = f.derivative(s, in);
    const auto k2 = f.derivative(add_scaled(s, 0.5 * h, k1), in);
    const auto k3 = f.derivative(add_scaled(s, 0.5 * h, k2), in);
    const auto k4 = f.derivative(add_scaled(s, h, k3), in);
    s = add_scaled(add_scaled(add_scaled(add_scaled(s, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
  }
  return s;
}

}  // namespace farrier::plant::test
