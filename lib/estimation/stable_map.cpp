#include "estimation/stable_map.hpp"

#include <cmath>
#include <complex>
#include <optional>

#include "control/numerics/francis.hpp"
#include "estimation/poles.hpp"

namespace farrier::estimation {
namespace {

// Condition of the eigenvectors (Frobenius norms) beyond which half the digits of the mapped matrix are lost.
constexpr double kWorstCondition = 1e8;
constexpr double kMapTolerance = 1e-9;
constexpr double kSameEigenvalue = 1e-7;   // of its modulus
constexpr double kHasEigenvectors = 1e-10;  // of the squared norm: what (m - z I)(m - w I) of such a matrix may be

template <int N>
using ComplexColumn = Eigen::Matrix<std::complex<double>, N, 1>;

template <int N>
using Square = Eigen::Matrix<double, N, N>;
template <int N>
using ComplexSquare = Eigen::Matrix<std::complex<double>, N, N>;

/// m - z I.
template <int N>
ComplexSquare<N> shifted(const Square<N>& m, std::complex<double> z) noexcept {
  ComplexSquare<N> result;
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) {
      result(i, j) = m(i, j) - (i == j ? z : 0.0);
    }
  }
  return result;
}

/// A vector of length one that m maps to zero (with `left` its transpose does), where that leaves one direction only. Not
/// finite where it leaves more.
template <int N>
ComplexColumn<N> null_vector(const ComplexSquare<N>& m, bool left) noexcept {
  ComplexColumn<N> best = ComplexColumn<N>::Zero();
  double largest = 0.0;
  const auto entry = [&](int i, int j) { return left ? m(j, i) : m(i, j); };
  const auto offer = [&](const ComplexColumn<N>& candidate) {
    if (const double size = candidate.squaredNorm(); size > largest) {
      largest = size;
      best = candidate;
    }
  };
  // A vector that is orthogonal to N - 1 rows, of which the most independent give the longest.
  for (int i = 0; i < N; ++i) {
    if constexpr (N == 2) {
      offer({entry(i, 1), -entry(i, 0)});
    } else {
      const int j = (i + 1) % N;
      offer({entry(i, 1) * entry(j, 2) - entry(i, 2) * entry(j, 1), entry(i, 2) * entry(j, 0) - entry(i, 0) * entry(j, 2),
             entry(i, 0) * entry(j, 1) - entry(i, 1) * entry(j, 0)});
    }
  }
  return best / std::sqrt(largest);
}

/// Projector on the eigenvector of z along all others, for an eigenvalue that no other one equals.
template <int N>
ComplexSquare<N> projector(const Square<N>& m, std::complex<double> z) noexcept {
  const ComplexSquare<N> rest = shifted<N>(m, z);
  const ComplexColumn<N> right = null_vector<N>(rest, false);
  const ComplexColumn<N> left = null_vector<N>(rest, true);
  std::complex<double> product = 0.0;
  for (int i = 0; i < N; ++i) {
    product += left(i) * right(i);
  }
  ComplexSquare<N> result;
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) {
      result(i, j) = right(i) * left(j) / product;
    }
  }
  return result;
}

/// The eigenvalue that two of them equal, and the third where there is one.
template <int N>
struct Repeated {
  std::complex<double> twice;
  std::complex<double> once;  ///< equal to `twice` where all are the same
};

template <int N>
std::optional<Repeated<N>> find_repeated(const ComplexColumn<N>& z) noexcept {
  for (int i = 0; i < N; ++i) {
    const int j = (i + 1) % N;
    if (std::abs(z(i) - z(j)) <= kSameEigenvalue * std::abs(z(i))) {
      const std::complex<double> other = z((i + 2) % N);
      const bool all = N == 2 || std::abs(other - z(i)) <= kSameEigenvalue * std::abs(z(i));
      return Repeated<N>{z(i), all ? z(i) : other};
    }
  }
  return std::nullopt;
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
  // a = sum of z_i P_i, with the projectors P_i on the eigenvectors: the same with each z_i moved.
  const auto moved = [limit](std::complex<double> pole) {
    const double modulus = std::abs(pole);
    return modulus > limit ? pole * (limit / modulus) : pole;
  };
  ComplexSquare<N> sum = ComplexSquare<N>::Zero();
  double condition_square = 0.0;
  if (const auto repeated = find_repeated<N>(z)) {
    const ComplexSquare<N> one = shifted<N>(a, repeated->twice);
    const ComplexSquare<N> other = shifted<N>(a, repeated->once);
    const bool all = repeated->once == repeated->twice;
    const double left = all ? one.norm() * a.norm() : (one * other).norm();
    if (!(left <= kHasEigenvectors * a.squaredNorm())) {
      return StabilityStatus::kEigenvalueError;
    }
    sum = moved(repeated->twice) * ComplexSquare<N>::Identity();
    if (!all) {
      const ComplexSquare<N> p = projector<N>(a, repeated->once);
      condition_square = N * p.squaredNorm();
      sum += (moved(repeated->once) - moved(repeated->twice)) * p;
    }
  } else {
    for (int i = 0; i < N; ++i) {
      const ComplexSquare<N> p = projector<N>(a, z(i));
      condition_square += N * p.squaredNorm();
      sum += moved(z(i)) * p;
    }
  }
  if (!(condition_square <= kWorstCondition * kWorstCondition)) {
    return StabilityStatus::kEigenvalueError;
  }
  const Square<N> mapped = sum.real();
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
