#include "control/design/filtered_loop.hpp"

#include <array>
#include <span>

#include "control/design/closed_loop.hpp"

namespace farrier::control {
namespace {

/// The closed loop with filters: states of closed_loop_matrix(), then those of each filter.
constexpr int kMaxFilteredStates = kMaxStates + 3 * MeasurementFilter::kMaxOrder;
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
  const std::array<const MeasurementFilter*, 3> all{&filters.position, &filters.velocity, &filters.force};
  const auto used = std::span(all).last(static_cast<std::size_t>(plant));
  int size = states;
  for (const MeasurementFilter* filter : used) {
    size += filter->order;
  }
  FilteredMatrix whole = FilteredMatrix::Zero(size, size);
  whole.topLeftCorner(states, states) = own;
  int at = states;
  int channel = 1;  // the column of the channel's state
  for (const MeasurementFilter* f : used) {
    const SmallColumn read = loop.col(channel) - own.col(channel);
    whole.block(0, channel, states, 1) += read * f->b[0];
    // Transposed direct form II, as LowPass runs it: y = b_0 u + s_1, s_i[k+1] = s_i+1 + b_i u - a_i y.
    for (int i = 0; i < f->order; ++i) {
      const auto tap = static_cast<std::size_t>(i) + 1;
      whole(at + i, channel) = f->b[tap] - f->a[tap] * f->b[0];
      whole(at + i, at) -= f->a[tap];
      if (i + 1 < f->order) {
        whole(at + i, at + i + 1) += 1.0;
      }
    }
    if (f->order > 0) {
      whole.block(0, at, states, 1) = read;
    }
    at += f->order;
    ++channel;
  }
  return whole.allFinite() && vanishes(whole);
}

}  // namespace farrier::control
