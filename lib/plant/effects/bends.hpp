#pragma once

#include "plant/effects/equations_with_effects.hpp"
#include "plant/runge_kutta.hpp"
#include "plant/substep_control.hpp"

namespace farrier::plant {

/// True if the pressure of a chamber, or with lines that of the oil behind a port, strides over a bend in a trial step
/// of length `h` from `state` with its `derivative`. With lines the ports meet the pressures behind the valve; the
/// chambers' then only know their voids.
template <class Equations, class State>
bool meets_bend(const Equations& equations, const typename Equations::Input& input, const State& state,
                const State& derivative, const TrialStep<State>& trial, double laminar_Pa, double h) noexcept {
  const HeldInput valve = equations.valve(state, input);
  const auto strides = [&](auto at, double port_Pa) noexcept {
    return strides_over_bend(at(state), at(derivative), at(trial.state), at(trial.end_derivative), port_Pa, laminar_Pa,
                             h);
  };
  if (strides([](const State& s) noexcept { return s.compression_a_Pa; }, valve.port_a_Pa) ||
      strides([](const State& s) noexcept { return s.compression_b_Pa; }, valve.port_b_Pa)) {
    return true;
  }
  if constexpr (requires { equations.effects().lines(); }) {
    constexpr std::size_t a = Effects::at<Lines>();
    return equations.effects().lines().active() &&
           (strides([](const State& s) noexcept { return s.x[a]; }, valve.port_a_Pa) ||
            strides([](const State& s) noexcept { return s.x[a + 1]; }, valve.port_b_Pa));
  } else {
    return false;
  }
}

}  // namespace farrier::plant
