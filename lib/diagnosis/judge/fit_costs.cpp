#include "diagnosis/judge/fit_costs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "diagnosis/judge/lane_slopes.hpp"

namespace farrier::diagnosis {
namespace {

class SideCost : public ceres::CostFunction {
 public:
  SideCost(const FitData& data, Span span, Channel channel, const Model& model, const std::vector<FreeNumber>& free,
           const FitOptions& options)
      : simulator_(*data.simulator), span_(span), channel_(channel), model_(model), free_(free), options_(options) {
    skip_ = std::min(span.size(), static_cast<std::size_t>(options.warm_up_s / simulator_.period_s()));
    scale_ = 1.0 / (data.weight[static_cast<std::size_t>(channel)] * std::sqrt(options.samples_per_fact));
    set_num_residuals(static_cast<int>(span.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(free.size()));
  }

  bool Evaluate(double const* const* parameters, double* residual, double** jacobians) const override {
    Model model = model_;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      number_at(model, free_[i].place) = parameters[0][i];
    }
    const std::vector<double>& truth = simulator_.measured(channel_);
    const auto put = [&](const std::vector<double>& simulated) {
      for (std::size_t i = 0; i < span_.size(); ++i) {
        residual[i] = judged(i) ? scale_ * (truth[span_.begin + i] - simulated[i]) : 0.0;
      }
    };
    if (jacobians == nullptr || jacobians[0] == nullptr) {
      put(simulator_.simulate(span_, model, channel_, options_.observer));
      return finite(residual);
    }
    const std::size_t columns = free_.size();
    if (std::equal(last_.at.begin(), last_.at.end(), parameters[0], parameters[0] + columns)) {
      std::ranges::copy(last_.residual, residual);
      std::ranges::copy(last_.jacobian, jacobians[0]);
      return true;
    }
    std::fill_n(jacobians[0], span_.size() * columns, 0.0);
    put(simulate_with_slopes(simulator_, span_, model, channel_, options_.observer, free_,
                             [&](std::size_t sample, std::size_t number, double slope) {
                               if (judged(sample)) {
                                 jacobians[0][sample * columns + number] = -scale_ * slope;
                               }
                             }));
    if (!finite(residual)) {
      return false;
    }
    last_.at.assign(parameters[0], parameters[0] + columns);
    last_.residual.assign(residual, residual + span_.size());
    last_.jacobian.assign(jacobians[0], jacobians[0] + span_.size() * columns);
    return true;
  }

 private:
  bool judged(std::size_t i) const noexcept { return i >= skip_ && simulator_.explains(channel_, span_.begin + i); }
  bool finite(const double* residual) const {
    return std::all_of(residual, residual + span_.size(), [](double r) { return std::isfinite(r); });
  }

  const Simulator& simulator_;
  Span span_;
  Channel channel_;
  const Model& model_;
  const std::vector<FreeNumber>& free_;
  const FitOptions& options_;
  std::size_t skip_;
  double scale_;
  /// The last derivatives. A fit's deviations need those of its last step again.
  struct Last {
    std::vector<double> at, residual, jacobian;
  };
  mutable Last last_;
};

/// Pull of the nominal factors towards one.
class PriorCost : public ceres::CostFunction {
 public:
  explicit PriorCost(const std::vector<FreeNumber>& free) : free_(free) {
    set_num_residuals(static_cast<int>(free.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(free.size()));
  }
  bool Evaluate(double const* const* parameters, double* residual, double** jacobians) const override {
    const std::size_t n = free_.size();
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      std::fill_n(jacobians[0], n * n, 0.0);
    }
    for (std::size_t i = 0; i < n; ++i) {
      const double per = free_[i].spread > 0.0 ? 1.0 / free_[i].spread : 0.0;
      residual[i] = per * (parameters[0][i] - free_[i].prior);
      if (jacobians != nullptr && jacobians[0] != nullptr) {
        jacobians[0][i * n + i] = per;
      }
    }
    return true;
  }

 private:
  const std::vector<FreeNumber>& free_;
};

}  // namespace

double& number_at(Model& model, std::size_t place) {
  if (place < kNominals) {
    return model.factors[place];
  }
  place -= kNominals;
  for (Model::Effect& effect : model.effects) {
    if (place < effect.fitted.size()) {
      return effect.fitted[place];
    }
    place -= effect.fitted.size();
  }
  std::abort();
}

ceres::CostFunction* side_cost(const FitData& data, Span span, Channel channel, const Model& model,
                               const std::vector<FreeNumber>& free, const FitOptions& options) {
  return new SideCost(data, span, channel, model, free, options);
}

ceres::CostFunction* prior_cost(const std::vector<FreeNumber>& free) { return new PriorCost(free); }

}  // namespace farrier::diagnosis
