#include "diagnosis/judge/linearised.hpp"

#include <algorithm>

#include <Eigen/Cholesky>

#include "diagnosis/judge/fit_costs.hpp"
#include "diagnosis/judge/lane_slopes.hpp"

namespace farrier::diagnosis {
namespace {

/// Least diagonal of a normal matrix, over its largest element: numbers that nothing shows stay where they are.
constexpr double kLeastDiagonal = 1e-9;

}  // namespace

Linearised linearised(const Bench& bench, Span span, const Model& model, Channel channel,
                      const std::vector<FreeNumber>& free, double unit) {
  const Simulator& simulator = bench.simulator();
  const FitOptions& options = bench.options();
  const double scale = 1.0 / unit;
  const auto skip = static_cast<std::size_t>(options.warm_up_s / simulator.period_s());
  const std::vector<double>& measured = simulator.measured(channel);
  const auto judged = [&](std::size_t i) { return i >= skip && simulator.explains(channel, span.begin + i); };
  const auto rows = static_cast<Eigen::Index>(span.size());
  Linearised out{Eigen::VectorXd::Zero(rows), Eigen::MatrixXd::Zero(rows, std::ssize(free))};
  const std::vector<double> simulated = simulate_with_slopes(
      simulator, span, model, channel, options.observer, free,
      [&](std::size_t sample, std::size_t number, double slope) {
        if (judged(sample)) {
          out.slope(static_cast<Eigen::Index>(sample), static_cast<Eigen::Index>(number)) = scale * slope;
        }
      });
  for (std::size_t i = skip; i < span.size(); ++i) {
    if (judged(i)) {
      out.residual[static_cast<Eigen::Index>(i)] = scale * (measured[span.begin + i] - simulated[i]);
    }
  }
  return out;
}

std::vector<FreeNumber> numbers_of_last_effect(const Simulator& simulator, const Model& with, const ChannelMask& shows,
                                               std::size_t count) {
  std::size_t first = kNominals;
  for (std::size_t i = 0; i + count < with.effects.size(); ++i) {
    first += with.effects[i].fitted.size();
  }
  std::vector<FreeNumber> numbers = simulator.free_numbers(with, shows, 0.0);
  std::erase_if(numbers, [first](const FreeNumber& number) { return number.place < first; });
  return numbers;
}

Eigen::VectorXd bounded_step(Eigen::MatrixXd normal, const Eigen::VectorXd& descent,
                             const std::vector<FreeNumber>& free, Model from) {
  for (Eigen::Index i = 0; i < std::ssize(free); ++i) {
    if (const double spread = free[static_cast<std::size_t>(i)].spread; spread > 0.0) {
      normal(i, i) += 1.0 / (spread * spread);
    }
  }
  normal.diagonal().array() += kLeastDiagonal * std::max(normal.diagonal().maxCoeff(), 1e-300);
  Eigen::VectorXd step = normal.ldlt().solve(descent);
  for (Eigen::Index i = 0; i < std::ssize(free); ++i) {
    const FreeNumber& number = free[static_cast<std::size_t>(i)];
    const double now = number_at(from, number.place);
    step[i] = std::clamp(now + step[i], number.low, number.high) - now;
  }
  return step;
}

}  // namespace farrier::diagnosis
