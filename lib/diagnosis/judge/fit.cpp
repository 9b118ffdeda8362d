#include "diagnosis/judge/fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>
#include <ceres/ceres.h>
#include <glog/logging.h>

#include "diagnosis/judge/fit_costs.hpp"

namespace farrier::diagnosis {
namespace {

/// A fit that fails is an answer, not news for the terminal.
void quieten_ceres() { [[maybe_unused]] static const int level = FLAGS_minloglevel = google::GLOG_FATAL; }

/// Standard deviations by the sandwich of blocks (Liang and Zeger 1986): residuals of a block may say the same thing.
Eigen::VectorXd deviations(ceres::Problem& problem, const std::vector<FreeNumber>& free, std::size_t block) {
  ceres::CRSMatrix sparse;
  std::vector<double> residual;
  problem.Evaluate(ceres::Problem::EvaluateOptions(), nullptr, &residual, nullptr, &sparse);
  const auto n = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd bread = 1e-9 * Eigen::MatrixXd::Identity(n, n);
  Eigen::MatrixXd meat = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(n);
  const std::size_t rows = residual.size();
  for (std::size_t row = 0; row < rows; ++row) {
    Eigen::VectorXd slope = Eigen::VectorXd::Zero(n);
    for (int i = sparse.rows[row]; i < sparse.rows[row + 1]; ++i) {
      slope[sparse.cols[static_cast<std::size_t>(i)]] = sparse.values[static_cast<std::size_t>(i)];
    }
    bread += slope * slope.transpose();
    gradient += slope * residual[row];
    if (row + free.size() >= rows || (row + 1) % block == 0) {
      meat += gradient * gradient.transpose();
      gradient.setZero();
    }
  }
  const Eigen::MatrixXd inverse = bread.ldlt().solve(Eigen::MatrixXd::Identity(n, n));
  return (inverse * meat * inverse).diagonal().cwiseMax(0.0).cwiseSqrt();
}

/// A projected step that ends at a bound leaves the other numbers short of their best: solves for them alone.
void solve_for_the_rest(const ceres::Solver::Options& solver, ceres::Problem& problem, std::vector<double>& values,
                        const std::vector<FreeNumber>& free, ceres::Solver::Summary& summary) {
  std::vector<int> held;
  for (std::size_t i = 0; i < free.size(); ++i) {
    if (values[i] <= free[i].low || values[i] >= free[i].high) {
      held.push_back(static_cast<int>(i));
    }
  }
  if (!held.empty() && held.size() < free.size()) {
    problem.SetManifold(values.data(), new ceres::SubsetManifold(static_cast<int>(free.size()), held));
    ceres::Solve(solver, &problem, &summary);
    problem.SetManifold(values.data(), nullptr);
  }
}

}  // namespace

std::vector<double> residuals(const Simulator& simulator, Span span, const Model& model, Channel channel,
                              const FitOptions& options) {
  std::vector<double> out = simulator.simulate(span, model, channel, options.observer);
  const std::vector<double>& truth = simulator.measured(channel);
  const auto skip = static_cast<std::size_t>(options.warm_up_s / simulator.period_s());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const bool judged = i >= skip && simulator.explains(channel, span.begin + i);
    out[i] = judged ? truth[span.begin + i] - out[i] : 0.0;
  }
  return out;
}

double judged_rms(const std::vector<double>& residuals) noexcept {
  double sum = 0.0;
  std::size_t count = 0;
  for (const double residual : residuals) {
    sum += residual * residual;
    count += residual != 0.0 ? 1 : 0;
  }
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0;
}

FitResult fit(const FitData& data, Span span, const Model& start, const ChannelMask& mask, const FitOptions& options) {
  FitResult result{.model = start, .cost = 0.0, .deviation = {}};
  const std::vector<FreeNumber> free = data.simulator->free_numbers(start, mask, options.nominal_spread);
  if (free.empty()) {
    return result;
  }
  std::vector<double> values;
  for (const FreeNumber& f : free) {
    values.push_back(std::clamp(number_at(result.model, f.place), f.low, f.high));
  }
  quieten_ceres();
  ceres::Problem problem;
  for (std::size_t c = 0; c < kChannels; ++c) {
    const bool moves = std::ranges::any_of(free, [c](const FreeNumber& f) { return f.channels[c]; });
    if (mask[c] && data.judged[c] && moves) {
      problem.AddResidualBlock(side_cost(data, span, static_cast<Channel>(c), start, free, options), nullptr,
                               values.data());
    }
  }
  if (problem.NumResidualBlocks() == 0) {
    return result;
  }
  problem.AddResidualBlock(prior_cost(free), nullptr, values.data());
  for (std::size_t i = 0; i < free.size(); ++i) {
    problem.SetParameterLowerBound(values.data(), static_cast<int>(i), free[i].low);
    problem.SetParameterUpperBound(values.data(), static_cast<int>(i), free[i].high);
  }
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  solver.max_num_iterations = options.most_iterations;
  solver.function_tolerance = options.tolerance;
  solver.logging_type = ceres::SILENT;
  solver.num_threads = 1;
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
  if (options.again_at_bounds && summary.IsSolutionUsable()) {
    solve_for_the_rest(solver, problem, values, free, summary);
  }
  std::size_t numbers = 0;
  for (const Model::Effect& effect : start.effects) {
    numbers += effect.fitted.size();
  }
  if (!summary.IsSolutionUsable()) {  // the start itself makes no finite simulation
    result.cost = std::numeric_limits<double>::infinity();
    result.deviation.assign(numbers, std::numeric_limits<double>::infinity());
    return result;
  }
  result.cost = summary.final_cost;
  for (std::size_t i = 0; i < free.size(); ++i) {
    number_at(result.model, free[i].place) = values[i];
  }
  const Eigen::VectorXd deviation =
      deviations(problem, free, static_cast<std::size_t>(options.block_s / data.simulator->period_s()));
  std::size_t place = kNominals;
  for (const Model::Effect& effect : result.model.effects) {
    for (std::size_t i = 0; i < effect.fitted.size(); ++i, ++place) {
      const auto at = std::ranges::find(free, place, &FreeNumber::place);
      result.deviation.push_back(at == free.end() ? 0.0 : deviation[at - free.begin()]);
    }
  }
  return result;
}

}  // namespace farrier::diagnosis
