#include "estimation/stable_map.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>

#include "estimation/poles.hpp"

namespace farrier::estimation {
namespace {

// Condition of the eigenvectors (Frobenius norms) beyond which half the digits of the mapped matrix are lost.
constexpr double kWorstCondition = 1e8;
constexpr double kMapTolerance = 1e-9;

template <int N>
using Solver = Eigen::EigenSolver<Eigen::Matrix<double, N, N>>;

}  // namespace

const char* to_string(StabilityStatus status) noexcept {
  switch (status) {
    case StabilityStatus::kNotYetSet: return "not yet set";
    case StabilityStatus::kStable: return "stable";
    case StabilityStatus::kMappedToStable: return "mapped to stable";
    case StabilityStatus::kEigenvalueError: return "eigenvalue error";
  }
  return "unknown status";
}

template <int N>
StabilityStatus map_to_stable(Eigen::Matrix<double, N, N>& a, double limit) noexcept {
  using ComplexMatrix = Eigen::Matrix<std::complex<double>, N, N>;
  const double radius = std::abs(poles<N>(a)[0]);
  if (radius <= limit) {
    return StabilityStatus::kStable;
  }
  if (!std::isfinite(radius)) {
    return StabilityStatus::kEigenvalueError;
  }
  const Solver<N> solver(a);
  if (solver.info() != Eigen::Success) {
    return StabilityStatus::kEigenvalueError;
  }
  const ComplexMatrix v = solver.eigenvectors();
  const ComplexMatrix inverse = v.inverse();
  if (!(v.norm() * inverse.norm() <= kWorstCondition)) {
    return StabilityStatus::kEigenvalueError;
  }
  Eigen::Matrix<std::complex<double>, N, 1> z = solver.eigenvalues();
  for (int i = 0; i < N; ++i) {
    const double modulus = std::abs(z(i));
    z(i) *= modulus > limit ? limit / modulus : 1.0;
  }
  const Eigen::Matrix<double, N, N> mapped = (v * z.asDiagonal() * inverse).real();
  // Real poles beyond the limit now coincide, where poles() has half its digits.
  const Solver<N> check(mapped, false);
  if (check.info() != Eigen::Success || !(check.eigenvalues().cwiseAbs().maxCoeff() <= limit + kMapTolerance)) {
    return StabilityStatus::kEigenvalueError;
  }
  a = mapped;
  return StabilityStatus::kMappedToStable;
}

template StabilityStatus map_to_stable(Eigen::Matrix<double, 2, 2>&, double) noexcept;
template StabilityStatus map_to_stable(Eigen::Matrix<double, 3, 3>&, double) noexcept;

}  // namespace farrier::estimation
