#pragma once

#include <Eigen/Core>

#include <complex>

#include "control/model/discretise.hpp"

namespace farrier::control {

/// Input matrix B(s) of a current that acts during the last share s of a tick alone: the integral of e^(a t) b over s
/// periods. It is f(A) B with f(z) = (z^s - 1) / (z - 1), by Newton's interpolation on the eigenvalues of A (Higham 2008,
/// "Functions of Matrices", 1.2.2). The model must have been sampled from a continuous one.
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
