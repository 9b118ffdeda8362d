#include "control/design/filtered_loop.hpp"

#include "control/design/closed_loop.hpp"

namespace farrier::control {
namespace {

/// The closed loop with filters: states of closed_loop_matrix(), then two of each filter.
constexpr int kMaxFilteredStates = kMaxStates + 6;
using FilteredMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxFilteredStates, kMaxFilteredStates>;

/// True if powers of `m` vanish: squares it until its norm is small or large. A radius within 1e-6 of one is neither,
/// and counts as unstable.
bool vanishes(FilteredMatrix m) noexcept {
  constexpr int kSquarings = 24;
  for (int i = 0; i < kSquarings; ++i) {
    const double norm = m.norm();
    if (!(norm > 1e-2 && norm < 1e50)) {
      return norm <= 1e-2;
    }
    m = (m * m).eval();
  }
  return false;
}

}  // namespace

bool filtered_loop_is_stable(const DiscreteModel& model, const Gains& gains, int delay_ticks,
                             const MeasurementFilters& filters) noexcept {
  const SmallMatrix loop = closed_loop_matrix(model, gains, delay_ticks);
  const int states = static_cast<int>(loop.rows());
  const int plant = gains.form == Form::kFullState ? 3 : 2;
  Gains silent = gains;
  silent.position = silent.velocity = silent.force = 0.0;
  SmallMatrix own = closed_loop_matrix(model, silent, delay_ticks);
  own(0, plant) = 0.0;  // without measurements; the sum is the only part that reads the force
  FilteredMatrix whole = FilteredMatrix::Zero(states + 2 * plant, states + 2 * plant);
  whole.topLeftCorner(states, states) = own;
  for (int i = 0; i < plant; ++i) {
    const int channel = i + 3 - plant;
    const MeasurementFilter& f = channel == 0 ? filters.position : (channel == 1 ? filters.velocity : filters.force);
    const SmallColumn read = loop.col(1 + i) - own.col(1 + i);
    whole.block(0, 1 + i, states, 1) += read * f.d;
    whole.block(0, states + 2 * i, states, 2) += read * f.c;
    whole.block<2, 2>(states + 2 * i, states + 2 * i) = f.a;
    whole.block<2, 1>(states + 2 * i, 1 + i) = f.b;
  }
  return whole.allFinite() && vanishes(whole);
}

}  // namespace farrier::control
