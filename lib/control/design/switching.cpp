#include "control/design/switching.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/portable_math.hpp"
#include "control/design/closed_loop.hpp"
#include "control/numerics/common_lyapunov.hpp"

namespace farrier::control {
namespace {

using switching::kStates;
using switching::largest_ratio;
using switching::lyapunov;
using switching::Matrix6;

struct Pair {
  std::array<Matrix6, 2> loop;
  std::array<Matrix6, 2> entry;
};

Matrix6 padded(const SmallMatrix& m) noexcept {
  Matrix6 whole = Matrix6::Zero();
  whole.topLeftCorner(m.rows(), m.cols()) = m;
  return whole;
}

Matrix6 power(Matrix6 m, int exponent) noexcept {
  Matrix6 result = Matrix6::Identity();
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) {
      result = (result * m).eval();
    }
    m = (m * m).eval();
  }
  return result;
}

/// Bound on V over a stay of `ticks` in each loop, there and back: the product of the largest of V_i after the stay in i
/// over V_j before it.
double growth(const Pair& pair, const std::array<Matrix6, 2>& p, int ticks) noexcept {
  double product = 1.0;
  for (std::size_t i = 0; i < 2; ++i) {
    product *= largest_ratio(power(pair.loop[i], ticks - 1) * pair.entry[i], p[i], p[1 - i]);
  }
  return product;
}

/// Least dwell for which growth() is below one. A longer stay only shrinks V: A_i'P_iA_i < P_i.
int least_dwell(const Pair& pair, const std::array<Matrix6, 2>& p) noexcept {
  int high = 1;
  while (high < kNoDwell && !(growth(pair, p, high) < 1.0)) {
    high *= 2;
  }
  if (high >= kNoDwell) {
    return kNoDwell;
  }
  int low = high / 2;  // does not suffice
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    (growth(pair, p, middle) < 1.0 ? high : low) = middle;
  }
  return high;
}

double single_rate(const Matrix6& loop, const Matrix6& p) noexcept { return std::sqrt(largest_ratio(loop, p, p)); }

SwitchingVerdict by_dwell(const Pair& pair) noexcept {
  const Matrix6 identity = Matrix6::Identity();
  const std::array<Matrix6, 2> own{lyapunov(pair.loop[0], identity), lyapunov(pair.loop[1], identity)};
  // Functions that weigh states as the other loop does fit each other better.
  const std::array<Matrix6, 2> crossed{lyapunov(pair.loop[0], own[1]), lyapunov(pair.loop[1], own[0])};
  SwitchingVerdict best{.common = false, .dwell_ticks = kNoDwell, .rate = 1.0};
  const std::array<std::array<Matrix6, 2>, 4> choices{{own, crossed, {own[0], crossed[1]}, {crossed[0], own[1]}}};
  for (const std::array<Matrix6, 2>& p : choices) {
    // Certifies the functions: for an unstable loop the sum overflows and p is invalid.
    if (!switching::is_common(p[0], {&pair.loop[0], 1}) || !switching::is_common(p[1], {&pair.loop[1], 1})) {
      continue;
    }
    const int dwell = least_dwell(pair, p);
    if (dwell < best.dwell_ticks) {
      const double there_and_back = portable::pow(growth(pair, p, dwell), 0.25 / dwell);
      best = {.common = false,
              .dwell_ticks = dwell,
              .rate = std::max({there_and_back, single_rate(pair.loop[0], p[0]), single_rate(pair.loop[1], p[1])})};
    }
  }
  return best;
}

SwitchingVerdict verdict(const Pair& pair) noexcept {
  const bool free_entry = pair.entry[0] == pair.loop[0] && pair.entry[1] == pair.loop[1];
  const std::array<Matrix6, 4> loops{pair.loop[0], pair.loop[1], pair.loop[0] * pair.entry[0],
                                     pair.loop[1] * pair.entry[1]};
  Matrix6 p;
  if (!switching::find_common({loops.data(), free_entry ? std::size_t{2} : loops.size()}, p)) {
    return by_dwell(pair);
  }
  double rate = std::max(single_rate(loops[0], p), single_rate(loops[1], p));
  if (!free_entry) {
    rate = std::max({rate, std::sqrt(single_rate(loops[2], p)), std::sqrt(single_rate(loops[3], p))});
  }
  return {.common = true, .dwell_ticks = free_entry ? 1 : 2, .rate = rate};
}

bool same(const Normalisation& a, const Normalisation& b) noexcept {
  return a.position == b.position && a.velocity == b.velocity && a.force == b.force && a.current_A == b.current_A;
}

}  // namespace

SwitchedLoop switched_loop(const DiscreteModel& model, const Gains& gains, int delay_ticks,
                           const DiscreteModel& before) noexcept {
  // c[k] = xi K_I sum[k] - K x[k] - K_d past[k]
  SmallMatrix loop = closed_loop_matrix(model, gains, delay_ticks);
  const Eigen::Index states = loop.rows();
  const Eigen::Index plant = gains.form == Form::kFullState ? 3 : 2;
  const double per_sum = gains.integral_factor * gains.integral;
  SmallMatrix to_command = SmallMatrix::Identity(states, states);
  to_command(0, 0) = per_sum;
  to_command.row(0).segment(1, plant) = -Eigen::RowVector3d(gains.position, gains.velocity, gains.force).tail(plant);
  for (Eigen::Index i = 1 + plant; i < states; ++i) {
    to_command(0, i) = -gains.delay[static_cast<std::size_t>(i - 1 - plant)];
  }
  SmallMatrix to_sum = SmallMatrix::Identity(states, states);
  to_sum.row(0) = -to_command.row(0) / per_sum;
  to_sum(0, 0) = 1.0 / per_sum;

  SwitchedLoop result;
  result.loop = to_command.lazyProduct(loop.lazyProduct(to_sum).eval());
  // Plant and past inputs of the tick before a change follow the old plant and the command, from either controller;
  // then c[k] = c[k-1] - K (x[k] - x[k-1]).
  loop = closed_loop_matrix(before, gains, delay_ticks);
  result.entry = to_command.lazyProduct(loop.lazyProduct(to_sum).eval());
  SmallMatrix change = result.entry - SmallMatrix::Identity(states, states);
  result.entry.row(0).setZero();
  result.entry(0, 0) = 1.0;
  for (Eigen::Index i = 1; i <= plant; ++i) {
    result.entry.row(0) += to_command(0, i) * change.row(i);
  }
  return result;
}

SwitchingVerdict switching_verdict(const SwitchedLoop& first, const SwitchedLoop& second) noexcept {
  const SwitchingVerdict none{.common = false, .dwell_ticks = kNoDwell, .rate = 1.0};
  const Eigen::Index n = first.loop.rows();
  for (const SmallMatrix* m : {&first.loop, &first.entry, &second.loop, &second.entry}) {
    if (m->rows() != n || m->cols() != n || !m->allFinite()) {
      return none;
    }
  }
  return verdict({{padded(first.loop), padded(second.loop)}, {padded(first.entry), padded(second.entry)}});
}

SwitchingVerdict switching_verdict(const DiscreteModel& first_model, const Gains& first_gains,
                                   const DiscreteModel& second_model, const Gains& second_gains,
                                   int delay_ticks) noexcept {
  if (!same(first_gains.normalisation, second_gains.normalisation) || first_gains.form != second_gains.form) {
    return {.common = false, .dwell_ticks = kNoDwell, .rate = 1.0};
  }
  return switching_verdict(switched_loop(first_model, first_gains, delay_ticks, second_model),
                           switched_loop(second_model, second_gains, delay_ticks, first_model));
}

}  // namespace farrier::control
