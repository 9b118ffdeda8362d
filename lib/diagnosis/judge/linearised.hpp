#pragma once

#include <vector>

#include <Eigen/Core>

#include "diagnosis/judge/hypothesis.hpp"

namespace farrier::diagnosis {

/// Residuals of a channel over a span, measured less simulated, and derivatives of the simulation by numbers, a column
/// each. All are divided by a unit, and zero where the residual is not judged.
struct Linearised {
  Eigen::VectorXd residual;
  Eigen::MatrixXd slope;
};

/// `unit` in N | m/s, positive.
Linearised linearised(const Bench& bench, Span span, const Model& model, Channel channel,
                      const std::vector<FreeNumber>& free, double unit);

}  // namespace farrier::diagnosis
