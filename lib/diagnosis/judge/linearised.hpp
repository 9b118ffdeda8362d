#pragma once

#include <vector>

#include <Eigen/Core>

#include "diagnosis/judge/fit.hpp"

namespace farrier::diagnosis {

/// Residuals of a channel over a span, measured less simulated, and derivatives of the simulation by numbers, a column
/// each. All are divided by a unit, and zero where the residual is not judged.
struct Linearised {
  Eigen::VectorXd residual;
  Eigen::MatrixXd slope;
};

/// `unit` in N | m/s, positive.
Linearised linearised(const Simulator& simulator, const FitOptions& options, Span span, const Model& model,
                      Channel channel, const std::vector<FreeNumber>& free, double unit);

/// Numbers of the last `count` effects of `with` that a fit may change on channels of `shows`.
std::vector<FreeNumber> numbers_of_last_effect(const Simulator& simulator, const Model& with, const ChannelMask& shows,
                                               std::size_t count = 1);

/// Least squares step of `free` from their places in `from`, the best that leaves each number within its range. The normal
/// matrix comes without the weight of priors, which is added here.
Eigen::VectorXd bounded_step(Eigen::MatrixXd normal, const Eigen::VectorXd& descent,
                             const std::vector<FreeNumber>& free, Model from);

}  // namespace farrier::diagnosis
