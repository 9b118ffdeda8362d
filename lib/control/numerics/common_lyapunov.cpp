#include "control/numerics/common_lyapunov.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/portable_math.hpp"
#include "control/numerics/symmetric_eigen.hpp"

namespace farrier::control::switching {
namespace {

constexpr int kEntries = kStates * (kStates + 1) / 2;  // of a symmetric matrix
constexpr int kUnknowns = kEntries;                    // those without trace, and the slack t
constexpr int kMaxSumDoublings = 40;
constexpr double kRoundingMargin = 1e-10;
constexpr double kFirstWeight = 1.0;
constexpr double kWeightGrowth = 4.0;
constexpr double kCentred = 0.5;  // Newton decrement below which the weight grows
constexpr double kGiveUp = 1e-9;  // of t: what a duality gap this small leaves positive stays positive
constexpr double kBackOff = 0.5;
constexpr int kMaxBackOffs = 30;

using Packed = Eigen::Matrix<double, kEntries, 1>;
using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;
using Hessian = Eigen::Matrix<double, kUnknowns, kUnknowns>;
using Basis = std::array<Matrix6, kUnknowns>;
using Cholesky = Eigen::LLT<Matrix6>;

/// Entries of a symmetric matrix with tr(A B) = packed(A)'packed(B).
Packed packed(const Matrix6& m) noexcept {
  Packed p;
  int next = 0;
  for (int j = 0; j < kStates; ++j) {
    p(next++) = m(j, j);
    for (int i = 0; i < j; ++i) {
      p(next++) = std::sqrt(2.0) * m(i, j);
    }
  }
  return p;
}

/// Orthonormal basis of the symmetric matrices without trace; the last place is not used.
Basis traceless_basis() noexcept {
  Basis basis;
  std::size_t next = 0;
  for (int j = 0; j < kStates; ++j) {
    for (int i = 0; i < j; ++i) {
      basis[next] = Matrix6::Zero();
      basis[next](i, j) = basis[next](j, i) = std::sqrt(0.5);
      ++next;
    }
  }
  for (int j = 1; j < kStates; ++j) {  // (1, .., 1, -j, 0, ..)
    basis[next] = Matrix6::Zero();
    for (int i = 0; i < j; ++i) {
      basis[next](i, i) = 1.0;
    }
    basis[next](j, j) = -j;
    basis[next] *= 1.0 / std::sqrt(j * (j + 1.0));
    ++next;
  }
  basis[next] = Matrix6::Zero();
  return basis;
}

Matrix6 symmetric_part(const Matrix6& m) noexcept { return 0.5 * (m + m.transpose()); }

/// P - m'P m.
Matrix6 decrease(const Matrix6& p, const Matrix6& m) noexcept { return symmetric_part(p - m.transpose() * p * m); }

/// Barrier problem: minimise w t - sum log det(P - M_i'P M_i + t I) - log det P over P with tr P = kStates, and t.
class Barrier {
 public:
  explicit Barrier(std::span<const Matrix6> loops) noexcept : loops_(loops), basis_(traceless_basis()) {
    for (std::size_t i = 0; i < loops.size(); ++i) {
      for (std::size_t j = 0; j + 1 < kUnknowns; ++j) {
        directions_[i][j] = decrease(basis_[j], loops[i]);
      }
      directions_[i][kUnknowns - 1] = Matrix6::Identity();
    }
    directions_[loops.size()] = basis_;
  }

  /// Value of the barrier; infinite outside.
  double value(const Matrix6& p, double t, double weight) const noexcept {
    double sum = weight * t;
    for (std::size_t i = 0; i <= loops_.size(); ++i) {
      const Cholesky cholesky(slack(i, p, t));
      if (cholesky.info() != Eigen::Success) {
        return std::numeric_limits<double>::infinity();
      }
      const double determinant = cholesky.matrixLLT().diagonal().prod();
      sum -= 2.0 * portable::log(determinant);
    }
    return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
  }

  /// Newton direction from (p, t); returns its decrement, negative when there is none.
  double newton(const Matrix6& p, double t, double weight, Matrix6& dp, double& dt) const noexcept {
    Hessian hessian = Hessian::Zero();
    Unknowns gradient = Unknowns::Unit(kUnknowns - 1) * weight;
    for (std::size_t i = 0; i <= loops_.size(); ++i) {
      const Cholesky cholesky(slack(i, p, t));
      Eigen::Matrix<double, kEntries, kUnknowns> scaled;
      for (std::size_t j = 0; j < kUnknowns; ++j) {
        Matrix6 g = cholesky.matrixL().solve(directions_[i][j]);
        g = cholesky.matrixL().solve(g.transpose().eval());
        gradient(static_cast<Eigen::Index>(j)) -= g.trace();
        scaled.col(static_cast<Eigen::Index>(j)) = packed(g);
      }
      hessian += scaled.transpose().lazyProduct(scaled);
    }
    const Eigen::LLT<Hessian> cholesky(hessian);
    const Unknowns step = cholesky.solve(-gradient);
    if (cholesky.info() != Eigen::Success || !step.allFinite()) {
      return -1.0;
    }
    dp = Matrix6::Zero();
    for (std::size_t j = 0; j + 1 < kUnknowns; ++j) {
      dp += step(static_cast<Eigen::Index>(j)) * basis_[j];
    }
    dt = step(kUnknowns - 1);
    return std::sqrt(std::max(0.0, -step.dot(gradient)));
  }

  double slack_count() const noexcept { return kStates * static_cast<double>(loops_.size() + 1); }

 private:
  Matrix6 slack(std::size_t i, const Matrix6& p, double t) const noexcept {
    if (i == loops_.size()) {
      return p;
    }
    return decrease(p, loops_[i]) + t * Matrix6::Identity();
  }

  std::span<const Matrix6> loops_;
  Basis basis_;
  std::array<Basis, kMaxLoops + 1> directions_;
};

/// Interior point on t from P = I; true as soon as t is below zero and the P there passes.
bool descend(std::span<const Matrix6> loops, Matrix6& p) noexcept {
  const Barrier barrier(loops);
  p = Matrix6::Identity();
  double t = 0.0;
  for (const Matrix6& m : loops) {
    t = std::max(t, m.squaredNorm());  // above the largest eigenvalue of m'm - I
  }
  double weight = kFirstWeight;
  for (int step = 0; step < kMaxNewtonSteps; ++step) {
    Matrix6 dp;
    double dt = 0.0;
    const double decrement = barrier.newton(p, t, weight, dp, dt);
    if (decrement < 0.0) {
      return false;
    }
    if (decrement < kCentred) {
      // On the central path t is within slack_count / weight of the least one.
      if (t - barrier.slack_count() / weight > 0.0 || barrier.slack_count() / weight < kGiveUp) {
        return false;
      }
      weight *= kWeightGrowth;
      continue;
    }
    const double before = barrier.value(p, t, weight);
    double length = 1.0;
    int tries = 0;
    while (tries < kMaxBackOffs && !(barrier.value(p + length * dp, t + length * dt, weight) < before)) {
      length *= kBackOff;
      ++tries;
    }
    if (tries == kMaxBackOffs) {
      return false;
    }
    p += length * dp;
    t += length * dt;
    if (t < 0.0 && is_common(p, loops)) {
      return true;
    }
  }
  return false;
}

}  // namespace

Matrix6 lyapunov(const Matrix6& a, const Matrix6& q) noexcept {
  Matrix6 power = a;
  Matrix6 sum = q;
  for (int i = 0; i < kMaxSumDoublings; ++i) {
    const Matrix6 step = power.transpose() * sum * power;
    sum = symmetric_part(sum + step);
    if (!(step.norm() > std::numeric_limits<double>::epsilon() * sum.norm())) {
      return sum;
    }
    power = (power * power).eval();
  }
  return Matrix6::Constant(std::numeric_limits<double>::quiet_NaN());
}

double largest_ratio(const Matrix6& m, const Matrix6& p, const Matrix6& over) noexcept {
  const Cholesky cholesky(over);
  if (cholesky.info() != Eigen::Success) {
    return std::numeric_limits<double>::infinity();
  }
  Matrix6 g = cholesky.matrixL().solve(symmetric_part(m.transpose() * p * m));
  g = cholesky.matrixL().solve(g.transpose().eval());
  if (!g.allFinite()) {
    return std::numeric_limits<double>::infinity();
  }
  return symmetric_eigen<kStates>(symmetric_part(g)).values(kStates - 1);
}

bool is_common(const Matrix6& p, std::span<const Matrix6> loops) noexcept {
  const Matrix6 margin = kRoundingMargin * p;
  if (!p.allFinite() || Cholesky(p).info() != Eigen::Success) {
    return false;
  }
  for (const Matrix6& m : loops) {
    if (Cholesky(decrease(p, m) - margin).info() != Eigen::Success) {
      return false;
    }
  }
  return true;
}

bool find_common(std::span<const Matrix6> loops, Matrix6& p) noexcept {
  // Coordinates in which the sum of the single loops' functions is the identity.
  Matrix6 sum = Matrix6::Zero();
  for (const Matrix6& m : loops) {
    const Matrix6 single = lyapunov(m, Matrix6::Identity());
    sum += single / single.trace();
  }
  const Cholesky cholesky(sum);
  if (loops.size() > kMaxLoops || !sum.allFinite() || cholesky.info() != Eigen::Success) {
    return false;
  }
  if (is_common(sum, loops)) {
    p = sum;
    return true;
  }
  // With sum = L L' and x = L^-T y: M becomes L' M L^-T.
  std::array<Matrix6, kMaxLoops> balanced;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const Matrix6 left = cholesky.matrixU() * loops[i];
    balanced[i] = cholesky.matrixL().solve(left.transpose()).transpose();
  }
  Matrix6 q;
  if (!descend({balanced.data(), loops.size()}, q)) {
    return false;
  }
  p = symmetric_part(cholesky.matrixL() * q * cholesky.matrixL().transpose());
  return is_common(p, loops);
}

}  // namespace farrier::control::switching
