#pragma once

#include <vector>

#include <ceres/cost_function.h>

#include "diagnosis/judge/fit.hpp"

namespace farrier::diagnosis {

/// The number of a model at that place.
double& number_at(Model& model, std::size_t place);

/// Residuals of one channel over a span; everything outlives it.
ceres::CostFunction* side_cost(const FitData& data, Span span, Channel channel, const Model& model,
                               const std::vector<FreeNumber>& free, const FitOptions& options);

/// Pull of the nominal factors towards one.
ceres::CostFunction* prior_cost(const std::vector<FreeNumber>& free);

}  // namespace farrier::diagnosis
