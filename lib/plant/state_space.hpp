#pragma once

#include <Eigen/Core>

namespace farrier::plant {

/// Continuous linear model dx/dt = a x + b u of N states around an operating point: deviations in SI, u the valve
/// current in A. The function that gives the model names the states.
template <int N>
struct StateSpace {
  Eigen::Matrix<double, N, N> a = Eigen::Matrix<double, N, N>::Zero();
  Eigen::Matrix<double, N, 1> b = Eigen::Matrix<double, N, 1>::Zero();
};

/// States (position m|rad, velocity m/s|rad/s, load-cell force N|Nm), which are measured.
using LinearModel = StateSpace<3>;

}  // namespace farrier::plant
