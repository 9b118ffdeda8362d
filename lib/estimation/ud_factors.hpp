#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

// Every loop below has a length known to the compiler; unrolled, the factors stay in registers.
#define FARRIER_UNROLL _Pragma("GCC unroll 8")

namespace farrier::estimation {

/// A covariance P kept as U D U' with U unit upper triangular and D diagonal, D > 0 (Bierman 1977, "Factorization
/// methods for discrete sequential estimation", V.3). P therefore stays symmetric and positive definite under rounding.
template <int N>
class UdFactors {
 public:
  using Regressor = Eigen::Matrix<double, N, 1>;
  using Covariance = Eigen::Matrix<double, N, N>;

  /// Gain of a sample: Theta <- Theta + e (P h)' / (lambda + h'P h), (6.20).
  struct Gain {
    double direction[N];  ///< P h
    double inverse;       ///< 1 / (lambda + h'P h)
  };

  /// P = initial I, whose trace is to stay at or below `limit` (> N initial).
  UdFactors(double initial, double limit) noexcept
      : initial_(initial), limit_(limit), d_min_(kSmallestShare * std::min(limit, kLargestGrowth * initial)) {
    begin_anew();
  }

  /// P <- (P - P h h'P / (lambda + h'P h)) / lambda, (6.21). `inverse_lambda` = 1 / lambda.
  Gain update(const Regressor& h, double lambda, double inverse_lambda) noexcept {
    // Bierman (1977), V.3, with lambda for the variance of the measurement: f = U'h, g = D f,
    // alpha_j = lambda + sum_{i<=j} f_i g_i, the last of which is lambda + h'P h.
    double f[N], g[N], alpha[N], inverse[N];
    double sum = lambda;
    FARRIER_UNROLL
    for (int j = 0; j < N; ++j) {
      f[j] = h(j);
      FARRIER_UNROLL
      for (int i = 0; i < j; ++i) {
        f[j] += u_[j][i] * h(i);
      }
      g[j] = d_[j] * f[j];
      sum += f[j] * g[j];
      alpha[j] = sum;
      inverse[j] = 1.0 / sum;
    }
    // D <- D alpha_{j-1} / alpha_j / lambda; U_j <- U_j - f_j / alpha_{j-1} b; b <- b + U_j g_j, which ends as P h.
    Gain gain;
    double* b = gain.direction;
    double trace = 0.0;
    FARRIER_UNROLL
    for (int j = 0; j < N; ++j) {
      const double before = j == 0 ? lambda : alpha[j - 1];
      const double d = std::max(d_[j] * (before * inverse[j]) * inverse_lambda, d_min_);
      double column = 1.0;
      if (j > 0) {
        const double c = f[j] * inverse[j - 1];
        FARRIER_UNROLL
        for (int i = 0; i < j; ++i) {
          const double u = u_[j][i];
          const double updated = u - c * b[i];
          b[i] += u * g[j];
          u_[j][i] = updated;
          column += updated * updated;
        }
      }
      b[j] = g[j];
      d_[j] = d;
      trace += d * column;
    }
    trace_ = trace;
    gain.inverse = inverse[N - 1];
    return gain;
  }

  /// Scales a trace above the limit back to it. If scaling does not suffice, because entries of D lie at their floor,
  /// the factors have become meaningless: they are reset and the result is false.
  bool hold_limit() noexcept {
    if (trace_ <= limit_) [[likely]] {
      return true;
    }
    if (std::isfinite(trace_)) {
      scale((1.0 - kRoom) * limit_ / trace_);
      if (trace_ <= limit_) {
        return true;
      }
    }
    begin_anew();
    return false;
  }

  void begin_anew() noexcept { begin_from(Regressor::Constant(initial_)); }

  /// P = diag(variances); each is taken as at most the initial one.
  void begin_from(const Regressor& variances) noexcept {
    for (int j = 0; j < N; ++j) {
      std::fill(u_[j], u_[j] + N, 0.0);
      d_[j] = std::clamp(variances(j), d_min_, initial_);
    }
    trace_ = trace_of_factors();
  }

  double trace() const noexcept { return trace_; }

  /// P, symmetric.
  Covariance matrix() const noexcept {
    Covariance u = Covariance::Identity();
    for (int j = 0; j < N; ++j) {
      for (int i = 0; i < j; ++i) {
        u(i, j) = u_[j][i];
      }
    }
    Covariance p;
    for (int i = 0; i < N; ++i) {
      for (int j = i; j < N; ++j) {
        double sum = 0.0;
        for (int k = j; k < N; ++k) {
          sum += u(i, k) * d_[k] * u(j, k);
        }
        p(i, j) = sum;
        p(j, i) = sum;
      }
    }
    return p;
  }

  /// P(column, column).
  double variance(int column) const noexcept {
    double p = 0.0;
    for (int k = column; k < N; ++k) {
      const double u = k == column ? 1.0 : u_[k][column];
      p += u * u * d_[k];
    }
    return p;
  }

 private:
  // Standard deviations further apart than 1/eps cannot be distinguished. Entries of D therefore stop at eps^2 of the
  // largest covariance; without a limit that is the largest one estimates ever need.
  static constexpr double kSmallestShare =
      std::numeric_limits<double>::epsilon() * std::numeric_limits<double>::epsilon();
  static constexpr double kLargestGrowth = 1e12;  // from the first covariance on
  // Distance of a covariance put on its limit from it: more than the trace's own rounding.
  static constexpr double kRoom = 1e-14;

  void scale(double factor) noexcept {
    for (double& d : d_) {
      d = std::max(factor * d, d_min_);
    }
    trace_ = trace_of_factors();
  }

  double trace_of_factors() const noexcept {
    double trace = 0.0;
    for (int j = 0; j < N; ++j) {
      double column = 1.0;
      for (int i = 0; i < j; ++i) {
        column += u_[j][i] * u_[j][i];
      }
      trace += d_[j] * column;
    }
    return trace;
  }

  double initial_;
  double limit_;
  double d_min_;
  double u_[N][N] = {};  // [column][row], row < column; the rest is not read
  double d_[N] = {};
  double trace_ = 0.0;
};

}  // namespace farrier::estimation
