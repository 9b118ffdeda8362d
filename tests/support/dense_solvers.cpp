#include "tests/support/dense_solvers.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace farrier::test {

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& m) {
  return Eigen::EigenSolver<Eigen::MatrixXd>(m, false).eigenvalues();
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& m) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::VectorXd singular_values(const Eigen::MatrixXcd& m) {
  return Eigen::JacobiSVD<Eigen::MatrixXcd>(m).singularValues();
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& m) { return m.partialPivLu().inverse(); }

Eigen::VectorXcd solve(const Eigen::MatrixXcd& m, const Eigen::VectorXcd& b) { return m.partialPivLu().solve(b); }

}  // namespace farrier::test
