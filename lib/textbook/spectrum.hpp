#pragma once

#include <Eigen/Core>

namespace farrier::control::any_size {

/// Largest modulus of the eigenvalues of a square matrix; NaN when they cannot be computed. On the heap, for analysis.
double spectral_radius(const Eigen::MatrixXd& m);

/// control::stabilisability for any number of states and inputs. On the heap, for analysis.
double stabilisability(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace farrier::control::any_size
