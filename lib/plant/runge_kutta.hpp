#pragma once

#include <algorithm>
#include <cmath>

#include "plant/effects/equations_with_effects.hpp"
#include "plant/equations.hpp"

namespace farrier::plant {

/// A state whose every component is `sum(component)`, where component(k) reads the same place of another state.
template <class Sum>
IntegrationState assemble(const IntegrationState*, Sum sum) noexcept {
  return {sum([](const IntegrationState& k) noexcept { return k.position; }),
          sum([](const IntegrationState& k) noexcept { return k.velocity; }),
          sum([](const IntegrationState& k) noexcept { return k.compression_a_Pa; }),
          sum([](const IntegrationState& k) noexcept { return k.compression_b_Pa; })};
}
template <class Set, class Sum>
EffectState<Set> assemble(const EffectState<Set>*, Sum sum) noexcept {
  EffectState<Set> state;
  static_cast<IntegrationState&>(state) = assemble(static_cast<const IntegrationState*>(nullptr), sum);
  for (std::size_t i = 0; i < state.x.size(); ++i) {
    state.x[i] = sum([i](const EffectState<Set>& k) noexcept { return k.x[i]; });
  }
  return state;
}

inline bool finite(const IntegrationState& s) noexcept {
  return std::isfinite(s.position) && std::isfinite(s.velocity) && std::isfinite(s.compression_a_Pa) &&
         std::isfinite(s.compression_b_Pa);
}
template <class Set>
bool finite(const EffectState<Set>& s) noexcept {
  return finite(static_cast<const IntegrationState&>(s)) &&
         std::ranges::all_of(s.x, [](double value) { return std::isfinite(value); });
}

template <class State>
State add_scaled(const State& s, double h, const State& d) noexcept {
  return assemble(&s, [&](auto at) noexcept { return at(s) + h * at(d); });
}

/// One step of an embedded pair.
template <class State>
struct TrialStep {
  State state;           ///< fifth order
  State end_derivative;  ///< first stage of the next step (first same as last)
  State error;           ///< fifth minus fourth order: the local error of the fourth-order solution
};

/// Dormand and Prince (1980), RK5(4)7M: the coefficients of their Table 2.
template <class Equations, class State = typename Equations::State>
[[gnu::flatten]] TrialStep<State> dormand_prince_step(const Equations& equations,
                                                      const typename Equations::Input& input, const State& s,
                                                      const State& k1, double h) noexcept {
  const auto combine = [&s, h](auto slope) noexcept {
    return assemble(&s, [&](auto at) noexcept { return at(s) + h * slope(at); });
  };
  const auto f = [&](const State& at) noexcept { return equations.derivative(at, input); };

  const auto k2 = f(combine([&](auto at) noexcept { return (1.0 / 5) * at(k1); }));
  const auto k3 = f(combine([&](auto at) noexcept { return (3.0 / 40) * at(k1) + (9.0 / 40) * at(k2); }));
  const auto k4 =
      f(combine([&](auto at) noexcept { return (44.0 / 45) * at(k1) - (56.0 / 15) * at(k2) + (32.0 / 9) * at(k3); }));
  const auto k5 = f(combine([&](auto at) noexcept {
    return (19372.0 / 6561) * at(k1) - (25360.0 / 2187) * at(k2) + (64448.0 / 6561) * at(k3) - (212.0 / 729) * at(k4);
  }));
  const auto k6 = f(combine([&](auto at) noexcept {
    return (9017.0 / 3168) * at(k1) - (355.0 / 33) * at(k2) + (46732.0 / 5247) * at(k3) + (49.0 / 176) * at(k4) -
           (5103.0 / 18656) * at(k5);
  }));
  TrialStep<State> trial;
  trial.state = combine([&](auto at) noexcept {
    return (35.0 / 384) * at(k1) + (500.0 / 1113) * at(k3) + (125.0 / 192) * at(k4) - (2187.0 / 6784) * at(k5) +
           (11.0 / 84) * at(k6);
  });
  trial.end_derivative = f(trial.state);
  trial.error = assemble(&s, [&](auto at) noexcept {
    return h * ((71.0 / 57600) * at(k1) - (71.0 / 16695) * at(k3) + (71.0 / 1920) * at(k4) -
                (17253.0 / 339200) * at(k5) + (22.0 / 525) * at(k6) - (1.0 / 40) * at(trial.end_derivative));
  });
  return trial;
}

}  // namespace farrier::plant
