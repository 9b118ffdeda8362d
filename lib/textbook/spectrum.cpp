#include "textbook/spectrum.hpp"

#include <Eigen/Eigenvalues>

#include <limits>

#include "control/numerics/smallest_singular_value.hpp"

namespace farrier::control::any_size {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& m) {
  if (m.allFinite()) {
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(m, false);
    if (solver.info() == Eigen::Success) {
      return solver.eigenvalues();
    }
  }
  return Eigen::VectorXcd::Constant(m.rows(), kUnknown);
}

}  // namespace

double spectral_radius(const Eigen::MatrixXd& m) {
  const Eigen::VectorXcd z = eigenvalues(m);
  return z.hasNaN() ? kUnknown : z.cwiseAbs().maxCoeff();
}

double stabilisability(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const Eigen::VectorXcd modes = eigenvalues(a);
  return modes.hasNaN() || !b.allFinite() ? kUnknown : smallest_over<Eigen::MatrixXcd>(a, b, modes);
}

}  // namespace farrier::control::any_size
