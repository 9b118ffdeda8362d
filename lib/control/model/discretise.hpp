#pragma once

#include <Eigen/Core>

#include "plant/state_space.hpp"

namespace farrier::control {

/// Sampled model x[k+1] = a x[k] + b u[k] of N states in SI units.
template <int N>
struct SampledModel {
  Eigen::Matrix<double, N, N> a;
  Eigen::Matrix<double, N, 1> b;
};

/// The force model: x = (position m, velocity m/s, load-cell force N), u = valve current A, position relative to the
/// operating point of the linearisation.
using DiscreteModel = SampledModel<3>;

/// Exact sampling of dx/dt = a x + b u with the input held over each period (zero-order hold):
/// [A B; 0 1] = exp([a b; 0 0] T) (Van Loan 1978, "Computing integrals involving the matrix exponential").
/// The exponential is a balanced, scaled and squared diagonal Pade approximant (Higham 2005) with a bounded number
/// of squarings. Requires period_s > 0; a non-finite entry or period gives a non-finite model, which every design
/// refuses by name. For models of N = 3 and 4 states.
template <int N>
SampledModel<N> discretise(const plant::StateSpace<N>& model, double period_s) noexcept;

/// Same, of three states.
DiscreteModel discretise(const Eigen::Matrix3d& a, const Eigen::Vector3d& b, double period_s) noexcept;

}  // namespace farrier::control
