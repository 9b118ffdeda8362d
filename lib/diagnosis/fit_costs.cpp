#include "diagnosis/fit_costs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace farrier::diagnosis {
namespace {

constexpr std::size_t kOilNominals = 8;

bool overlap(const ChannelMask& a, const ChannelMask& b) noexcept {
  return (a[0] && b[0]) || (a[1] && b[1]) || (a[2] && b[2]);
}

/// Places of the nominal factor that an effect replaces, kNominals for none.
std::size_t replaced(plant::EffectId id) noexcept {
  using plant::Scale;
  const plant::EffectInfo& info = plant::effect_info(id);
  if (!info.nominal || info.side != plant::Side::kLoad) {
    return kNominals;
  }
  switch (info.parameters[0].scale) {
    case Scale::kMass:
      return static_cast<std::size_t>(Nominal::kMass);
    case Scale::kDamping:
      return static_cast<std::size_t>(Nominal::kDamping);
    default:
      return static_cast<std::size_t>(Nominal::kStiffness);
  }
}

class SideCost : public ceres::CostFunction {
 public:
  SideCost(const JointModel& joint, const FitData& data, Span span, Channel channel, const Model& model,
           const std::vector<FreeNumber>& free, const FitOptions& options)
      : joint_(joint), data_(data), span_(span), channel_(channel), model_(model), free_(free), options_(options) {
    skip_ = std::min(span.size(), static_cast<std::size_t>(options.warm_up_s / data.data->period_s));
    scale_ = 1.0 / (data.weight[static_cast<std::size_t>(channel)] * std::sqrt(options.samples_per_fact));
    set_num_residuals(static_cast<int>(span.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(free.size()));
  }

  bool Evaluate(double const* const* parameters, double* residual, double** jacobians) const override {
    Model model = model_;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      number_at(model, free_[i].place) = parameters[0][i];
    }
    const JointData& data = *data_.data;
    const std::vector<double>& truth = measured(data, channel_);
    const auto put = [&](const std::vector<double>& simulated) {
      for (std::size_t i = 0; i < span_.size(); ++i) {
        residual[i] = judged(i) ? scale_ * (truth[span_.begin + i] - simulated[i]) : 0.0;
      }
    };
    if (jacobians == nullptr || jacobians[0] == nullptr) {
      put(joint_.simulate(data, span_, model, channel_, options_.observer));
      return finite(residual);
    }
    const std::size_t columns = free_.size();
    std::fill_n(jacobians[0], span_.size() * columns, 0.0);
    std::vector<std::size_t> mine;
    for (std::size_t i = 0; i < columns; ++i) {
      if (free_[i].channels[static_cast<std::size_t>(channel_)]) {
        mine.push_back(i);
      }
    }
    bool first = true;
    for (std::size_t from = 0; from < mine.size() || first; from += JointModel::kLanes) {
      std::vector<std::size_t> lanes;
      for (std::size_t i = from; i < std::min(from + JointModel::kLanes, mine.size()); ++i) {
        lanes.push_back(free_[mine[i]].place);
      }
      std::vector<double> jacobian;
      const auto simulated = joint_.simulate_lanes(data, span_, model, channel_, options_.observer, lanes, jacobian);
      if (first) {
        put(simulated);
      }
      first = false;
      for (std::size_t i = 0; i < span_.size(); ++i) {
        for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
          jacobians[0][i * columns + mine[from + lane]] =
              judged(i) ? -scale_ * jacobian[i * lanes.size() + lane] : 0.0;
        }
      }
    }
    return finite(residual);
  }

 private:
  bool judged(std::size_t i) const noexcept {
    const JointData& data = *data_.data;
    return i >= skip_ && (channel_ != Channel::kMotion || knows_load(data, span_.begin + i));
  }
  bool finite(const double* residual) const {
    return std::all_of(residual, residual + span_.size(), [](double r) { return std::isfinite(r); });
  }

  const JointModel& joint_;
  const FitData& data_;
  Span span_;
  Channel channel_;
  const Model& model_;
  const std::vector<FreeNumber>& free_;
  const FitOptions& options_;
  std::size_t skip_;
  double scale_;
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

std::vector<FreeNumber> free_numbers(const JointModel& joint, const Model& model, const ChannelMask& mask,
                               const FitOptions& options) {
  std::vector<FreeNumber> free;
  for (std::size_t i = 0; i < kNominals; ++i) {
    const ChannelMask mine =
        i < kOilNominals ? ChannelMask{true, false, false} : ChannelMask{false, true, false};
    const bool taken = std::ranges::any_of(model.effects, [i](const auto& e) { return replaced(e.id) == i; });
    const bool absent = (i == static_cast<std::size_t>(Nominal::kStiffness) && joint.load().stiffness == 0.0) ||
                        (i == static_cast<std::size_t>(Nominal::kPistonMass) && joint.actuator().piston_mass == 0.0);
    if (overlap(mine, mask) && !taken && !absent) {
      free.push_back({i, mine, 1.0 - kNominalBand, 1.0 + kNominalBand, 1.0, options.nominal_spread});
    }
  }
  std::size_t place = kNominals;
  for (const Model::Effect& effect : model.effects) {
    const plant::EffectInfo& info = plant::effect_info(effect.id);
    const ChannelMask mine = channels_of(info.side);
    for (std::size_t i = 0; i < effect.fitted.size(); ++i, ++place) {
      const plant::Parameter& p = info.parameters[i];
      const bool known_slack = p.scale == plant::Scale::kLength && info.side == plant::Side::kLoad && i > 0 &&
                               joint.load().stiffness > 0.0;
      if (overlap(mine, mask) && !known_slack) {
        free.push_back({place, mine, p.low, p.high, 0.0, 0.0});
      }
    }
  }
  return free;
}

ceres::CostFunction* side_cost(const JointModel& joint, const FitData& data, Span span, Channel channel,
                               const Model& model, const std::vector<FreeNumber>& free, const FitOptions& options) {
  return new SideCost(joint, data, span, channel, model, free, options);
}

ceres::CostFunction* prior_cost(const std::vector<FreeNumber>& free) { return new PriorCost(free); }

}  // namespace farrier::diagnosis
