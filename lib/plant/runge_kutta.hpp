#pragma once

#include "plant/equations.hpp"

namespace farrier::plant {

inline IntegrationState add_scaled(const IntegrationState& s, double h, const IntegrationState& d) noexcept {
  return {s.position + h * d.position, s.velocity + h * d.velocity, s.compression_a_Pa + h * d.compression_a_Pa,
          s.compression_b_Pa + h * d.compression_b_Pa};
}

/// One step of an embedded pair.
struct TrialStep {
  IntegrationState state;           ///< fifth order
  IntegrationState end_derivative;  ///< first stage of the next step (first same as last)
  IntegrationState error;           ///< fifth minus fourth order: the local error of the fourth-order solution
};

/// Dormand and Prince (1980), RK5(4)7M: the coefficients of their Table 2.
inline TrialStep dormand_prince_step(const JointEquations& equations, const HeldInput& input,
                                     const IntegrationState& s, const IntegrationState& k1, double h) noexcept {
  const auto combine = [&s, h](auto member_sum) noexcept {
    return IntegrationState{
        s.position + h * member_sum(&IntegrationState::position),
        s.velocity + h * member_sum(&IntegrationState::velocity),
        s.compression_a_Pa + h * member_sum(&IntegrationState::compression_a_Pa),
        s.compression_b_Pa + h * member_sum(&IntegrationState::compression_b_Pa)};
  };
  const auto f = [&](const IntegrationState& at) noexcept { return equations.derivative(at, input); };

  const auto k2 = f(combine([&](auto m) noexcept { return (1.0 / 5) * k1.*m; }));
  const auto k3 = f(combine([&](auto m) noexcept { return (3.0 / 40) * k1.*m + (9.0 / 40) * k2.*m; }));
  const auto k4 = f(combine(
      [&](auto m) noexcept { return (44.0 / 45) * k1.*m - (56.0 / 15) * k2.*m + (32.0 / 9) * k3.*m; }));
  const auto k5 = f(combine([&](auto m) noexcept {
    return (19372.0 / 6561) * k1.*m - (25360.0 / 2187) * k2.*m + (64448.0 / 6561) * k3.*m - (212.0 / 729) * k4.*m;
  }));
  const auto k6 = f(combine([&](auto m) noexcept {
    return (9017.0 / 3168) * k1.*m - (355.0 / 33) * k2.*m + (46732.0 / 5247) * k3.*m + (49.0 / 176) * k4.*m -
           (5103.0 / 18656) * k5.*m;
  }));
  TrialStep trial;
  trial.state = combine([&](auto m) noexcept {
    return (35.0 / 384) * k1.*m + (500.0 / 1113) * k3.*m + (125.0 / 192) * k4.*m - (2187.0 / 6784) * k5.*m +
           (11.0 / 84) * k6.*m;
  });
  trial.end_derivative = f(trial.state);
  const auto error_of = [&](auto m) noexcept {
    return h * ((71.0 / 57600) * k1.*m - (71.0 / 16695) * k3.*m + (71.0 / 1920) * k4.*m -
                (17253.0 / 339200) * k5.*m + (22.0 / 525) * k6.*m - (1.0 / 40) * trial.end_derivative.*m);
  };
  trial.error = {error_of(&IntegrationState::position), error_of(&IntegrationState::velocity),
                 error_of(&IntegrationState::compression_a_Pa), error_of(&IntegrationState::compression_b_Pa)};
  return trial;
}

}  // namespace farrier::plant
