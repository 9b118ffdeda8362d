#pragma once

#include <Eigen/Core>

#include <complex>

#include "control/model/discretise.hpp"

namespace farrier::control {

/// What the input does to the states when it acts during the last share of a tick alone: B(s), the integral of e^(a t) b
/// over s periods, from a sampled model. With f(z) = (z^s - 1) / (z - 1) it is f(A) B, by Newton's interpolation on the
/// eigenvalues of A (Higham 2008, "Functions of Matrices", 1.2.2). Wants an A that was sampled from a continuous model.
class PartOfTick {
 public:
  explicit PartOfTick(const DiscreteModel& model) noexcept;

  /// B(share), share in [0, 1]; B(0) = 0, B(1) = B.
  Eigen::Vector3d input(double share) const noexcept;

 private:
  std::complex<double> poles_[3];
  Eigen::Vector3cd directions_[3];  ///< B, (A - p_0) B, (A - p_1) (A - p_0) B
};

}  // namespace farrier::control
