#include "control/closed_loop.hpp"

#include <limits>

#include "control/spectrum.hpp"

namespace farrier::control {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

enum State { kIntegral, kPosition, kVelocity, kForce, kLastInput, kSecondLastInput };

/// Transition of (sum of force errors, x, v, F, u[k-1], u[k-2]) at zero reference, normalised.
Matrix6 closed_loop_matrix(const DiscreteModel& model, const Gains& gains, int delay_ticks) noexcept {
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

}  // namespace

ClosedLoopPoles closed_loop_poles(const DiscreteModel& model, const Gains& gains, int delay_ticks) noexcept {
  const SmallSpectrum z = eigenvalues(closed_loop_matrix(model, gains, delay_ticks));
  ClosedLoopPoles poles;
  for (std::size_t i = 0; i < poles.size(); ++i) {
    poles[i] = z(static_cast<Eigen::Index>(i));
  }
  return poles;
}

double closed_loop_spectral_radius(const DiscreteModel& model, const Gains& gains, int delay_ticks) noexcept {
  const Matrix6 loop = closed_loop_matrix(model, gains, delay_ticks);
  if (gains.form == Form::kFullState) {
    return spectral_radius(loop);
  }
  SmallMatrix force_loop(5, 5);
  for (int row = 0, i = 0; row < 6; ++row) {
    if (row == kPosition) {
      continue;
    }
    force_loop(i, 0) = loop(row, kIntegral);
    force_loop.row(i++).tail<4>() = loop.row(row).tail<4>();
  }
  return spectral_radius(force_loop);
}

}  // namespace farrier::control
