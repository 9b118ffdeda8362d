#pragma once

#include <Eigen/Core>

namespace farrier::plant {

/// Continuous linear model dx/dt = a x + b u of N states around an operating point: deviations in SI, u the valve
/// current in A. What the states are, the function says that gives the model.
template <int N>
struct StateSpace {
  Eigen::Matrix<double, N, N> a = Eigen::Matrix<double, N, N>::Zero();
  Eigen::Matrix<double, N, 1> b = Eigen::Matrix<double, N, 1>::Zero();
};

/// States (position m|rad, velocity m/s|rad/s, load-cell force N|Nm): what is measured.
using LinearModel = StateSpace<3>;

}  // namespace farrier::plant
