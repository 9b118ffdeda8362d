#include "estimation/stable_map.hpp"

#include <cmath>
#include <complex>

#include "control/numerics/francis.hpp"
#include "estimation/poles.hpp"

namespace farrier::estimation {
namespace {

// Condition of the eigenvectors (Frobenius norms) beyond which half the digits of the mapped matrix are lost.
constexpr double kWorstCondition = 1e8;
constexpr double kMapTolerance = 1e-9;

template <int N>
using ComplexColumn = Eigen::Matrix<std::complex<double>, N, 1>;

/// A vector of length one that m - z I (or with `left` its transpose) maps to zero, for an eigenvalue z that no other one
/// equals. Not finite where another one does.
template <int N>
ComplexColumn<N> null_vector(const Eigen::Matrix<double, N, N>& m, std::complex<double> z, bool left) noexcept {
  std::complex<double> row[N][N];
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) {
      row[i][j] = (left ? m(j, i) : m(i, j)) - (i == j ? z : 0.0);
    }
  }
  ComplexColumn<N> best = ComplexColumn<N>::Zero();
  double largest = 0.0;
  const auto offer = [&](const ComplexColumn<N>& candidate) {
    if (const double size = candidate.squaredNorm(); size > largest) {
      largest = size;
      best = candidate;
    }
  };
  // A vector that is orthogonal to N - 1 rows, of which the most independent give the longest.
  if constexpr (N == 2) {
    for (const auto& r : row) {
      offer({r[1], -r[0]});
    }
  } else {
    for (int i = 0; i < N; ++i) {
      const auto& r = row[i];
      const auto& s = row[(i + 1) % N];
      offer({r[1] * s[2] - r[2] * s[1], r[2] * s[0] - r[0] * s[2], r[0] * s[1] - r[1] * s[0]});
    }
  }
  return best / std::sqrt(largest);
}

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
  const double radius = std::abs(poles<N>(a)[0]);
  if (radius <= limit) {
    return StabilityStatus::kStable;
  }
  ComplexColumn<N> z;
  if (!std::isfinite(radius) || !control::francis_eigenvalues<N>(a, z)) {
    return StabilityStatus::kEigenvalueError;
  }
  // a = V diag(z) V^-1, where row i of V^-1 is the left eigenvector over its product with the right one.
  Eigen::Matrix<double, N, N> mapped = Eigen::Matrix<double, N, N>::Zero();
  double inverse_square = 0.0;
  for (int i = 0; i < N; ++i) {
    const ComplexColumn<N> right = null_vector<N>(a, z(i), false);
    const ComplexColumn<N> left = null_vector<N>(a, z(i), true);
    std::complex<double> product = 0.0;
    for (int j = 0; j < N; ++j) {
      product += left(j) * right(j);
    }
    inverse_square += 1.0 / std::norm(product);
    const double modulus = std::abs(z(i));
    const std::complex<double> moved = z(i) * (modulus > limit ? limit / modulus : 1.0) / product;
    for (int j = 0; j < N; ++j) {
      for (int k = 0; k < N; ++k) {
        mapped(j, k) += (right(j) * moved * left(k)).real();
      }
    }
  }
  if (!(std::sqrt(N * inverse_square) <= kWorstCondition)) {
    return StabilityStatus::kEigenvalueError;
  }
  // Real poles beyond the limit now coincide, where poles() has half its digits.
  if (!control::francis_eigenvalues<N>(mapped, z) || !(z.cwiseAbs().maxCoeff() <= limit + kMapTolerance)) {
    return StabilityStatus::kEigenvalueError;
  }
  a = mapped;
  return StabilityStatus::kMappedToStable;
}

template StabilityStatus map_to_stable(Eigen::Matrix<double, 2, 2>&, double) noexcept;
template StabilityStatus map_to_stable(Eigen::Matrix<double, 3, 3>&, double) noexcept;

}  // namespace farrier::estimation
