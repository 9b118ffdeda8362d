#include "diagnosis/judge/fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Dense>

#include "diagnosis/judge/box_minimum.hpp"
#include "diagnosis/judge/linearised.hpp"

namespace farrier::diagnosis {
namespace {

/// Damping of the first step, over the diagonal of the normal matrix, and its least.
constexpr double kFirstDamping = 1e-4;
constexpr double kLeastDamping = 1e-16;
/// Least diagonal that is damped: a number that nothing shows stays.
constexpr double kLeastDamped = 1e-6;
/// Share of the predicted fall of the cost that a step must bring.
constexpr double kLeastFall = 1e-3;

/// The cost of a model and its derivatives by the free numbers.
class FitProblem {
 public:
  FitProblem(const FitData& data, Span span, const Model& start, const ChannelMask& mask, const FitOptions& options)
      : data_(data),
        span_(span),
        options_(options),
        model_(start),
        free_(data.simulator->free_numbers(start, mask, options.nominal_spread)) {
    for (std::size_t c = 0; c < kChannels; ++c) {
      const bool moves = std::ranges::any_of(free_, [c](const FreeNumber& f) { return f.channels[c]; });
      if (mask[c] && data.judged[c] && moves) {
        channels_.push_back(static_cast<Channel>(c));
      }
    }
  }

  const std::vector<FreeNumber>& free() const noexcept { return free_; }
  bool is_empty() const noexcept { return free_.empty() || channels_.empty(); }

  Eigen::VectorXd start() {
    Eigen::VectorXd values(std::ssize(free_));
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      const FreeNumber& number = at(i);
      values[i] = std::clamp(number_at(model_, number.place), number.low, number.high);
    }
    return values;
  }
  Model model_at(const Eigen::VectorXd& values) const {
    Model model = model_;
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      number_at(model, at(i).place) = values[i];
    }
    return model;
  }
  Eigen::VectorXd room(const Eigen::VectorXd& values, double FreeNumber::*bound) const {
    Eigen::VectorXd room(values.size());
    for (Eigen::Index i = 0; i < room.size(); ++i) {
      room[i] = at(i).*bound - values[i];
    }
    return room;
  }

  /// Weights of the priors: 1 over the spread, 0 without a prior.
  Eigen::VectorXd weight() const {
    Eigen::VectorXd weight(std::ssize(free_));
    for (Eigen::Index i = 0; i < weight.size(); ++i) {
      weight[i] = at(i).spread > 0.0 ? 1.0 / at(i).spread : 0.0;
    }
    return weight;
  }

  /// Half the sum of squares; not finite where the simulation is not.
  double cost(const Eigen::VectorXd& values) const {
    const Model model = model_at(values);
    double sum = pull(values).squaredNorm();
    for (const Channel channel : channels_) {
      const double unit = unit_of(channel);
      for (const double residual : residuals(*data_.simulator, span_, model, channel, options_)) {
        sum += residual * residual / (unit * unit);
      }
    }
    return 0.5 * sum;
  }

  struct Slopes {
    double cost = 0.0;
    Eigen::MatrixXd normal;
    Eigen::VectorXd descent;
    std::vector<Linearised> channels;
  };
  Slopes slopes(const Eigen::VectorXd& values) const {
    const Model model = model_at(values);
    const Eigen::VectorXd pull = this->pull(values);
    Slopes slopes{.cost = pull.squaredNorm(),
                  .normal = Eigen::MatrixXd(weight().cwiseAbs2().asDiagonal()),
                  .descent = weight().cwiseProduct(pull),
                  .channels = {}};
    for (const Channel channel : channels_) {
      slopes.channels.push_back(linearised(*data_.simulator, options_, span_, model, channel, free_, unit_of(channel)));
      const Linearised& mine = slopes.channels.back();
      slopes.cost += mine.residual.squaredNorm();
      slopes.normal.noalias() += mine.slope.transpose() * mine.slope;
      slopes.descent.noalias() += mine.slope.transpose() * mine.residual;
    }
    slopes.cost *= 0.5;
    return slopes;
  }

 private:
  const FreeNumber& at(Eigen::Index i) const { return free_[static_cast<std::size_t>(i)]; }
  double unit_of(Channel channel) const {
    return data_.weight[static_cast<std::size_t>(channel)] * std::sqrt(options_.samples_per_fact);
  }
  /// Residuals of the priors, which draw the nominal factors to one.
  Eigen::VectorXd pull(const Eigen::VectorXd& values) const {
    Eigen::VectorXd pull = weight();
    for (Eigen::Index i = 0; i < pull.size(); ++i) {
      pull[i] *= at(i).prior - values[i];
    }
    return pull;
  }

  const FitData& data_;
  Span span_;
  const FitOptions& options_;
  Model model_;
  std::vector<FreeNumber> free_;
  std::vector<Channel> channels_;
};

/// Standard deviations by the sandwich of blocks (Liang and Zeger 1986): residuals of a block may say the same thing. A
/// prior is one observation of its number, with the variance 1 / `weight` squared.
Eigen::VectorXd deviations(const FitProblem::Slopes& slopes, const Eigen::VectorXd& weight, Eigen::Index block) {
  const Eigen::Index n = slopes.descent.size();
  Eigen::MatrixXd meat(weight.cwiseAbs2().asDiagonal());
  for (const Linearised& channel : slopes.channels) {
    for (Eigen::Index row = 0; row < channel.residual.size(); row += block) {
      const Eigen::Index rows = std::min(block, channel.residual.size() - row);
      const Eigen::VectorXd gradient =
          channel.slope.middleRows(row, rows).transpose() * channel.residual.segment(row, rows);
      meat += gradient * gradient.transpose();
    }
  }
  const Eigen::MatrixXd bread = slopes.normal + 1e-9 * Eigen::MatrixXd::Identity(n, n);
  const Eigen::MatrixXd inverse = bread.ldlt().solve(Eigen::MatrixXd::Identity(n, n));
  return (inverse * meat * inverse).diagonal().cwiseMax(0.0).cwiseSqrt();
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
  FitProblem problem(data, span, start, mask, options);
  FitResult result{.model = start, .cost = 0.0, .deviation = {}};
  if (problem.is_empty()) {
    return result;
  }
  std::size_t numbers = 0;
  for (const Model::Effect& effect : start.effects) {
    numbers += effect.fitted.size();
  }
  Eigen::VectorXd values = problem.start();
  FitProblem::Slopes slopes = problem.slopes(values);
  result.cost = slopes.cost;
  if (!std::isfinite(slopes.cost) || !slopes.normal.allFinite()) {  // the start itself makes no finite simulation
    result.cost = std::numeric_limits<double>::infinity();
    result.deviation.assign(numbers, std::numeric_limits<double>::infinity());
    return result;
  }
  bool known = true;  // the slopes are those at the values
  double damping = kFirstDamping;
  double growth = 2.0;
  for (int iteration = 0; iteration < options.most_iterations; ++iteration) {
    if (!known) {
      FitProblem::Slopes next = problem.slopes(values);
      if (!std::isfinite(next.cost) || !next.normal.allFinite()) {
        break;
      }
      slopes = std::move(next);
      known = true;
    }
    Eigen::MatrixXd damped = slopes.normal;
    damped.diagonal() += damping * slopes.normal.diagonal().cwiseMax(kLeastDamped);
    const Eigen::VectorXd step = box_minimum(damped, slopes.descent, problem.room(values, &FreeNumber::low),
                                             problem.room(values, &FreeNumber::high));
    const double predicted = step.dot(slopes.descent) - 0.5 * step.dot(slopes.normal * step);
    if (!(predicted > 0.1 * options.tolerance * options.tolerance * result.cost)) {
      break;
    }
    const double cost = problem.cost(values + step);
    const double fall = result.cost - cost;
    if (!std::isfinite(cost) || fall < kLeastFall * predicted) {
      damping *= growth;
      growth *= 2.0;
      continue;
    }
    const double surplus = 2.0 * fall / predicted - 1.0;
    damping = std::max(damping * std::max(1.0 / 3.0, 1.0 - surplus * surplus * surplus), kLeastDamping);
    growth = 2.0;
    const bool settled = fall < options.tolerance * result.cost;
    values += step;
    result.cost = cost;
    known = false;
    if (settled) {
      break;
    }
  }
  result.model = problem.model_at(values);
  if (!options.deviations) {
    return result;
  }
  if (!known) {
    slopes = problem.slopes(values);
  }
  const Eigen::VectorXd deviation =
      deviations(slopes, problem.weight(), static_cast<Eigen::Index>(options.block_s / data.simulator->period_s()));
  for (std::size_t place = kNominals; place < kNominals + numbers; ++place) {
    const auto at = std::ranges::find(problem.free(), place, &FreeNumber::place);
    result.deviation.push_back(at == problem.free().end() ? 0.0 : deviation[at - problem.free().begin()]);
  }
  return result;
}

}  // namespace farrier::diagnosis
