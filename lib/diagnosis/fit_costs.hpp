#pragma once

#include <vector>

#include <ceres/cost_function.h>

#include "diagnosis/fit.hpp"

namespace farrier::diagnosis {

/// A number of a model that a fit may change.
struct FreeNumber {
  std::size_t place;  ///< as in JointModel::simulate_lanes
  ChannelMask channels;
  double low, high;
  double prior, spread;  ///< spread 0: none
};

/// Factors and numbers of effects of `model` that concern channels of `mask`.
std::vector<FreeNumber> free_numbers(const JointModel& joint, const Model& model, const ChannelMask& mask,
                                     const FitOptions& options);

/// The number of a model at that place.
double& number_at(Model& model, std::size_t place);

/// Residuals of one channel over a span; everything outlives it.
ceres::CostFunction* side_cost(const JointModel& joint, const FitData& data, Span span, Channel channel,
                               const Model& model, const std::vector<FreeNumber>& free, const FitOptions& options);

/// Pull of the nominal factors towards one.
ceres::CostFunction* prior_cost(const std::vector<FreeNumber>& free);

}  // namespace farrier::diagnosis
