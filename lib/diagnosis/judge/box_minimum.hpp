#pragma once

#include <Eigen/Core>

namespace farrier::diagnosis {

/// The x within low <= x <= high where x' normal x / 2 - descent' x is least, by an active set: numbers that reach a bound
/// are held there, and are released where the slope leads back inside; Stark and Parker (1995), "BVLS". `normal` is
/// symmetric and positive definite, and low <= 0 <= high, the first numbers.
Eigen::VectorXd box_minimum(const Eigen::MatrixXd& normal, const Eigen::VectorXd& descent, const Eigen::VectorXd& low,
                            const Eigen::VectorXd& high);

}  // namespace farrier::diagnosis
