#include "bench/bench_rls.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <vector>

#include "core/noise.hpp"
#include "estimation/rls.hpp"
#include "textbook/textbook_rls.hpp"

namespace farrier::bench {
namespace {

constexpr int kRlsRounds = 50;
constexpr double kForgetting = 0.95;
constexpr double kInitialCovariance = 1e3;
constexpr double kNoise = 1e-2;

template <int N>
struct Samples {
  std::vector<Eigen::Matrix<double, N, 1>> h;
  std::vector<Eigen::Vector3d> y;
  double scale = 0.0;  // largest parameter
};

/// y = Theta h + noise; with five regressors the last is 1.
template <int N>
Samples<N> regression_samples(int count) {
  const NoiseStream parameters(1, "parameters", "");
  const NoiseStream regressors(1, "regressors", "");
  const NoiseStream noise(1, "noise", "");
  Eigen::Matrix<double, 3, N> theta;
  for (int i = 0; i < theta.size(); ++i) {
    theta(i) = parameters.normal(i);
  }
  Samples<N> samples;
  samples.scale = theta.cwiseAbs().maxCoeff();
  for (Tick k = 0; k < count; ++k) {
    Eigen::Matrix<double, N, 1> h = Eigen::Matrix<double, N, 1>::Ones();
    for (int i = 0; i < 4; ++i) {
      h(i) = regressors.normal(4 * k + i);
    }
    const Eigen::Vector3d error(noise.normal(3 * k), noise.normal(3 * k + 1), noise.normal(3 * k + 2));
    samples.h.push_back(h);
    samples.y.push_back(theta * h + kNoise * error);
  }
  return samples;
}

template <int N>
estimation::Rls<N> rls_estimator() {
  return estimation::Rls<N>::create({kForgetting, kInitialCovariance, 1e9, 1e-9}).value();
}

/// Takes the time of one round, keeps the least.
template <class Estimator, int N>
void time_rls_round(Estimator& estimator, const Samples<N>& samples, double& best_s) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  for (std::size_t k = 0; k < samples.h.size(); ++k) {
    estimator.update(samples.h[k], samples.y[k]);
  }
  const std::chrono::duration<double> spent = Clock::now() - start;
  best_s = std::min(best_s, spent.count() / static_cast<double>(samples.h.size()));
}

double largest_difference(const Samples<4>& samples) {
  estimation::Rls<4> rls = rls_estimator<4>();
  textbook::TextbookRls<4> textbook(kForgetting, kInitialCovariance);
  double largest = 0.0;
  for (std::size_t k = 0; k < samples.h.size(); ++k) {
    rls.update(samples.h[k], samples.y[k]);
    textbook.update(samples.h[k], samples.y[k]);
    const double difference = (rls.parameters() - textbook.parameters()).cwiseAbs().maxCoeff() / samples.scale;
    largest = std::isnan(difference) ? difference : std::max(largest, difference);
  }
  return largest;
}

}  // namespace

RlsBench bench_rls(int samples, std::int64_t (*allocations_so_far)()) {
  const Samples<4> plain = regression_samples<4>(std::max(samples, 1));
  const Samples<5> with_bias = regression_samples<5>(std::max(samples, 1));
  estimation::Rls<4> rls = rls_estimator<4>();
  estimation::Rls<5> rls_bias = rls_estimator<5>();
  textbook::TextbookRls<4> textbook(kForgetting, kInitialCovariance);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  RlsBench bench{kInfinity, kInfinity, kInfinity, 0.0, -1};
  const std::int64_t before = allocations_so_far != nullptr ? allocations_so_far() : 0;
  for (int round = 0; round < kRlsRounds; ++round) {
    time_rls_round(rls, plain, bench.update_s);
    time_rls_round(rls_bias, with_bias, bench.update_bias_s);
    time_rls_round(textbook, plain, bench.textbook_s);
  }
  if (allocations_so_far != nullptr) {
    bench.allocations = allocations_so_far() - before;
  }
  bench.difference = largest_difference(plain);
  return bench;
}

}  // namespace farrier::bench
