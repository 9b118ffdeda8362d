#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "core/noise.hpp"

namespace farrier::estimation::testing {

/// Standard normal entries addressed by tick: the same on every machine.
template <int Rows, int Columns = 1>
Eigen::Matrix<double, Rows, Columns> normal(std::uint64_t seed, const char* name, Tick tick) {
  Eigen::Matrix<double, Rows, Columns> m;
  for (int i = 0; i < Rows * Columns; ++i) {
    m(i) = NoiseStream(seed, name, std::to_string(i)).normal(tick);
  }
  return m;
}

template <int N>
struct Sample {
  Eigen::Matrix<double, N, 1> h;
  Eigen::Vector3d y;
};

/// `count` samples of y = theta h + noise from tick `first` on, white regressors of variance one.
template <int N>
std::vector<Sample<N>> excited(const Eigen::Matrix<double, 3, N>& theta, double noise, int count, std::uint64_t seed,
                               Tick first = 0) {
  std::vector<Sample<N>> samples;
  for (Tick k = first; k < first + count; ++k) {
    const Eigen::Matrix<double, N, 1> h = normal<N>(seed, "regressor", k);
    samples.push_back({h, theta * h + noise * normal<3>(seed, "noise", k)});
  }
  return samples;
}

}  // namespace farrier::estimation::testing
