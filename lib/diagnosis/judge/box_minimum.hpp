#pragma once

#include <Eigen/Core>

namespace farrier::diagnosis {

/// Returns x within low <= x <= high at which x' normal x / 2 - descent' x is least, by an active set: Stark and Parker
/// (1995), "BVLS". Numbers that reach a bound are held there. They are released where the slope leads back inside. `normal`
/// is symmetric and positive definite, and 0, where the search begins, lies within the bounds.
Eigen::VectorXd box_minimum(const Eigen::MatrixXd& normal, const Eigen::VectorXd& descent, const Eigen::VectorXd& low,
                            const Eigen::VectorXd& high);

}  // namespace farrier::diagnosis
