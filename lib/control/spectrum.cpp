#include "control/spectrum.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>

namespace farrier::control {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Eigenvalues of a double integrator are only known to the root of the machine precision.
constexpr double kUnitCircleMargin = 1e-7;

double smallest_singular_value(const SmallMatrix& a, const SmallColumn& b, std::complex<double> z) noexcept {
  const Eigen::Index n = a.rows();
  using Pencil = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxStates + 1, kMaxStates>;
  Pencil pencil(n + 1, n);
  pencil.topRows(n) = a.transpose().cast<std::complex<double>>();
  pencil.topRows(n).diagonal().array() -= z;
  pencil.row(n) = b.transpose().cast<std::complex<double>>();
  const Eigen::JacobiSVD<Pencil> svd(pencil);
  return svd.singularValues()(n - 1);
}

}  // namespace

SmallSpectrum eigenvalues(const SmallMatrix& m) noexcept {
  if (m.allFinite()) {
    const Eigen::EigenSolver<SmallMatrix> solver(m, false);
    if (solver.info() == Eigen::Success) {
      return solver.eigenvalues();
    }
  }
  return SmallSpectrum::Constant(m.rows(), kNaN);
}

double spectral_radius(const SmallMatrix& m) noexcept {
  const SmallSpectrum z = eigenvalues(m);
  return z.hasNaN() ? kNaN : z.cwiseAbs().maxCoeff();
}

double stabilisability(const SmallMatrix& a, const SmallColumn& b) noexcept {
  const SmallSpectrum modes = eigenvalues(a);
  if (modes.hasNaN() || !b.allFinite()) {
    return kNaN;
  }
  double distance = smallest_singular_value(a, b, 1.0);
  for (const std::complex<double>& z : modes) {
    if (std::abs(z) >= 1.0 - kUnitCircleMargin && z.imag() >= 0.0) {
      distance = std::min(distance, smallest_singular_value(a, b, z));
    }
  }
  return distance;
}

}  // namespace farrier::control
