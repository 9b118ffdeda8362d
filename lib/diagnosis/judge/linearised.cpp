#include "diagnosis/judge/linearised.hpp"

#include "diagnosis/judge/lane_slopes.hpp"

namespace farrier::diagnosis {

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

}  // namespace farrier::diagnosis
