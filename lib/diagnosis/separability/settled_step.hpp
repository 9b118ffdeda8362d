#pragma once

#include <vector>

#include <Eigen/Core>

#include "diagnosis/model/simulator.hpp"

namespace farrier::diagnosis {

/// bounded_step() in which numbers that end at a bound stay there while the rest is solved again. Its arguments are the same.
Eigen::VectorXd settled_step(const Eigen::MatrixXd& normal, const Eigen::VectorXd& descent,
                             const std::vector<FreeNumber>& free, Model from);

}  // namespace farrier::diagnosis
