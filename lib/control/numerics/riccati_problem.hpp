#pragma once

// Parts of a Riccati equation that its solvers share: weights, gain, residual. Internal to control.

#include <Eigen/Cholesky>

#include <cmath>

#include "control/numerics/riccati.hpp"
#include "core/ensure.hpp"

namespace farrier::control::riccati {

inline constexpr double kSymmetryTolerance = 1e-12;
inline constexpr double kDefiniteTolerance = 1e-12;  // of the trace: rounding error of a semi-definite weight

template <int N>
using Square = Eigen::Matrix<double, N, N>;
template <int N, int M>
using Columns = Eigen::Matrix<double, N, M>;

template <int N, int M>
struct Problem {
  const Square<N>& a;
  const Columns<N, M>& b;
  const Square<N>& q;
  const InputWeight<M>& r;
  const Columns<N, M>& n;
};

template <int N>
Square<N> symmetric_part(const Square<N>& m) noexcept {
  return 0.5 * (m + m.transpose());
}

/// X R^-1 X' of a positive R.
template <int N, int M>
Square<N> weighted_square(const Columns<N, M>& x, const InputWeight<M>& r) noexcept {
  if constexpr (M == 1) {
    return x * x.transpose() / r;
  } else {
    return symmetric_part<N>(x * r.llt().solve(x.transpose()));
  }
}

/// X R^-1 Y' of a positive R.
template <int N, int M>
Square<N> weighted(const Columns<N, M>& x, const InputWeight<M>& r, const Columns<N, M>& y) noexcept {
  if constexpr (M == 1) {
    return x * y.transpose() / r;
  } else {
    return x * r.llt().solve(y.transpose());
  }
}

/// B'SB + R, of S B.
template <int N, int M>
InputWeight<M> total_weight(const Problem<N, M>& p, const Columns<N, M>& sb) noexcept {
  if constexpr (M == 1) {
    return p.b.dot(sb) + p.r;
  } else {
    return symmetric_part<M>(p.b.transpose() * sb) + p.r;
  }
}

/// (B'SB + R)^-1 (B'SA + N')
template <int N, int M>
Eigen::Matrix<double, M, N> gain(const Problem<N, M>& p, const Square<N>& s) noexcept {
  const Eigen::Matrix<double, M, N> bs = p.b.transpose() * s;
  const Eigen::Matrix<double, M, N> right = bs * p.a + p.n.transpose();
  const InputWeight<M> total = total_weight<N, M>(p, bs.transpose());
  if constexpr (M == 1) {
    return right / total;
  } else {
    return total.llt().solve(right);
  }
}

template <int N, int M>
void ensure_sizes([[maybe_unused]] const Problem<N, M>& p) noexcept {
  if constexpr (N == Eigen::Dynamic) {
    const Eigen::Index states = p.a.rows();
    const Eigen::Index inputs = p.b.cols();
    FARRIER_ENSURE(
        states > 0 && inputs > 0 && p.a.cols() == states && p.b.rows() == states &&
            p.q.rows() == states && p.q.cols() == states && p.r.rows() == inputs && p.r.cols() == inputs &&
            p.n.rows() == states && p.n.cols() == inputs,
        "the matrices of a Riccati equation fit each other");
  }
}

template <int N, int M>
bool is_finite(const Problem<N, M>& p) noexcept {
  bool finite = p.a.allFinite() && p.b.allFinite() && p.q.allFinite() && p.n.allFinite();
  if constexpr (M == 1) {
    return finite && std::isfinite(p.r);
  } else {
    return finite && p.r.allFinite();
  }
}

/// R > 0, judged with a diagonal of ones: inputs may have units of any size.
/// True if every pivot of an elimination is positive. Reads the lower triangle of a symmetric matrix.
template <int N>
bool is_positive_definite(Square<N> m) noexcept {
  for (Eigen::Index k = 0; k < m.rows(); ++k) {
    if (!(m(k, k) > 0.0)) {
      return false;
    }
    const double inverse = 1.0 / m(k, k);
    for (Eigen::Index i = k + 1; i < m.rows(); ++i) {
      const double factor = m(i, k) * inverse;
      for (Eigen::Index j = k + 1; j <= i; ++j) {
        m(i, j) -= factor * m(j, k);
      }
    }
  }
  return true;
}

template <int M>
bool is_positive(const InputWeight<M>& r) noexcept {
  if constexpr (M == 1) {
    return r > 0.0;
  } else {
    if ((r - r.transpose()).norm() > kSymmetryTolerance * r.norm() || !(r.diagonal().minCoeff() > 0.0)) {
      return false;
    }
    const Eigen::Matrix<double, M, 1> scale = r.diagonal().cwiseSqrt().cwiseInverse();
    Square<M> scaled = scale.asDiagonal() * r * scale.asDiagonal();
    scaled.diagonal().array() -= kDefiniteTolerance;
    return is_positive_definite<M>(scaled);
  }
}

template <int N, int M>
bool has_definite_weights(const Problem<N, M>& p) noexcept {
  if (!is_positive<M>(p.r) || (p.q - p.q.transpose()).norm() > kSymmetryTolerance * p.q.norm()) {
    return false;
  }
  Square<N> reduced = p.q - weighted_square<N, M>(p.n, p.r);
  if (reduced.isZero(0.0)) {
    return true;
  }
  const double trace = reduced.trace();
  reduced.diagonal().array() += kDefiniteTolerance * trace;
  return trace > 0.0 && is_positive_definite<N>(reduced);
}

}  // namespace farrier::control::riccati
