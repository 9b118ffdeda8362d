#pragma once

#include <Eigen/Core>

namespace farrier::test {

// LAPACK's dense solvers. Eigen's take the compiler ten seconds for every size.

/// Eigenvalues of a square matrix.
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& m);

/// Eigenvalues of a symmetric matrix, rising.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& m);

/// Singular values, falling.
Eigen::VectorXd singular_values(const Eigen::MatrixXcd& m);

Eigen::MatrixXd inverse(const Eigen::MatrixXd& m);

/// Solution x of m x = b.
Eigen::VectorXcd solve(const Eigen::MatrixXcd& m, const Eigen::VectorXcd& b);

}  // namespace farrier::test
