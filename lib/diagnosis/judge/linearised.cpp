#include "diagnosis/judge/linearised.hpp"

#include <algorithm>

#include "diagnosis/judge/box_minimum.hpp"
#include "diagnosis/judge/lane_slopes.hpp"

namespace farrier::diagnosis {
namespace {

/// Least diagonal of a normal matrix, over its largest element: numbers that nothing shows stay where they are.
constexpr double kLeastDiagonal = 1e-9;

}  // namespace

Linearised linearised(const Simulator& simulator, const FitOptions& options, Span span, const Model& model,
                      Channel channel, const std::vector<FreeNumber>& free, double unit) {
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
  Eigen::VectorXd low(std::ssize(free));
  Eigen::VectorXd high(std::ssize(free));
  for (Eigen::Index i = 0; i < std::ssize(free); ++i) {
    const FreeNumber& number = free[static_cast<std::size_t>(i)];
    if (number.spread > 0.0) {
      normal(i, i) += 1.0 / (number.spread * number.spread);
    }
    const double now = number_at(from, number.place);
    low[i] = std::min(number.low - now, 0.0);
    high[i] = std::max(number.high - now, 0.0);
  }
  const double largest = free.empty() ? 0.0 : normal.diagonal().maxCoeff();
  normal.diagonal().array() += kLeastDiagonal * std::max(largest, 1e-300);
  return box_minimum(normal, descent, low, high);
}

}  // namespace farrier::diagnosis
