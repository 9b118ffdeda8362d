#include "control/design/closed_loop.hpp"

#include <algorithm>
#include <limits>

#include "control/numerics/spectrum.hpp"

namespace farrier::control {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

enum State { kIntegral, kPosition, kVelocity, kForce, kLastInput, kSecondLastInput };

/// Transition of (sum of force errors, x, v, F, u[k-1], u[k-2]) at zero reference, normalised.
Matrix6 whole_loop(const DiscreteModel& model, const Gains& gains, int delay_ticks) noexcept {
  if (delay_ticks < 0 || delay_ticks > kMaxDelayTicks) {
    return Matrix6::Constant(std::numeric_limits<double>::quiet_NaN());
  }
  const DiscreteModel plant = normalise(model, gains.normalisation);
  Eigen::Matrix<double, 1, 6> command;
  command << gains.integral_factor * gains.integral, -gains.position, -gains.velocity, -gains.force, -gains.delay[0],
      -gains.delay[1];
  Matrix6 loop = Matrix6::Zero();
  loop(kIntegral, kIntegral) = 1.0;
  loop(kIntegral, kForce) = -1.0;
  loop.block<3, 3>(kPosition, kPosition) = plant.a;
  if (delay_ticks == 0) {
    loop.middleRows<3>(kPosition) += plant.b * command;
  } else {
    loop.block<3, 1>(kPosition, delay_ticks == 1 ? kLastInput : kSecondLastInput) += plant.b;
  }
  loop.row(kLastInput) = command;
  loop(kSecondLastInput, kLastInput) = 1.0;
  return loop;
}

/// Number of past inputs in the loop. Older ones have no effect and add poles at zero.
int past_inputs(const Gains& gains, int delay_ticks) noexcept {
  const int read_by_gains = gains.delay[1] != 0.0 ? 2 : (gains.delay[0] != 0.0 ? 1 : 0);
  return std::clamp(delay_ticks, read_by_gains, kMaxDelayTicks);
}

}  // namespace

ClosedLoopPoles closed_loop_poles(const DiscreteModel& model, const Gains& gains, int delay_ticks) noexcept {
  const SmallSpectrum z = eigenvalues(whole_loop(model, gains, delay_ticks));
  ClosedLoopPoles poles;
  for (std::size_t i = 0; i < poles.size(); ++i) {
    poles[i] = z(static_cast<Eigen::Index>(i));
  }
  return poles;
}

SmallMatrix closed_loop_matrix(const DiscreteModel& model, const Gains& gains, int delay_ticks) noexcept {
  const Matrix6 loop = whole_loop(model, gains, delay_ticks);
  const int past = past_inputs(gains, delay_ticks);
  if (gains.form == Form::kFullState) {
    return loop.topLeftCorner(kLastInput + past, kLastInput + past);
  }
  constexpr std::array kForceLoop{kIntegral, kVelocity, kForce, kLastInput, kSecondLastInput};
  const int states = 3 + past;
  SmallMatrix force_loop(states, states);
  for (int i = 0; i < states; ++i) {
    for (int j = 0; j < states; ++j) {
      force_loop(i, j) = loop(kForceLoop[static_cast<std::size_t>(i)], kForceLoop[static_cast<std::size_t>(j)]);
    }
  }
  return force_loop;
}

SmallSpectrum closed_loop_spectrum(const DiscreteModel& model, const Gains& gains, int delay_ticks) noexcept {
  return eigenvalues(closed_loop_matrix(model, gains, delay_ticks));
}

double closed_loop_spectral_radius(const DiscreteModel& model, const Gains& gains, int delay_ticks) noexcept {
  return largest_modulus(closed_loop_spectrum(model, gains, delay_ticks));
}

}  // namespace farrier::control
