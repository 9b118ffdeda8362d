#include "bench/bench_estimators.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <vector>

#include "core/ensure.hpp"
#include "core/noise.hpp"
#include "estimation/joint_estimator.hpp"

namespace farrier::bench {
namespace {

using estimation::EstimationMethod;
using estimation::GateKind;

constexpr int kEstimatorsRounds = 20;

/// A stable joint of unit scales whose states and input are normal, small enough to have full weight.
std::vector<estimation::JointSample> make_samples(int ticks) {
  const NoiseStream noise(1, "bench", "");
  std::vector<estimation::JointSample> samples;
  Eigen::Vector3d state = Eigen::Vector3d::Zero();
  for (Tick k = 0; k < ticks; ++k) {
    estimation::JointSample sample;
    sample.tick = k;
    sample.current_A = 1e-3 * noise.normal(4 * k);
    state = Eigen::Vector3d(state(0) + 1e-3 * state(1), 0.9 * state(1) + 0.1 * state(2),
                            0.5 * state(2) - 0.3 * state(1) + sample.current_A);
    sample.state = state + 1e-5 * Eigen::Vector3d(noise.normal(4 * k + 1), noise.normal(4 * k + 2), noise.normal(4 * k + 3));
    samples.push_back(sample);
  }
  return samples;
}

estimation::JointEstimator estimator(EstimationMethod method, GateKind gate) {
  estimation::EstimatorParams params;
  params.method = method;
  params.gate = gate;
  params.fft = estimation::SpectrumParams{.magnitude_min = 1e-6};  // open for signals as small as make_samples' are
  params.position = false;
  Eigen::Matrix3d a = Eigen::Matrix3d::Identity();
  a(0, 1) = 1e-3;
  const estimation::JointScales scales{.state = Eigen::Vector3d::Ones(),
                                       .current_A = 1.0,
                                       .sensor_noise = Eigen::Vector3d::Constant(1e-5),
                                       .home_position = 0.0,
                                       .period_s = 1e-3,
                                       .input_delay_ticks = 0};
  return estimation::JointEstimator::create(params, scales, a, Eigen::Vector3d::UnitZ()).value();
}

double least_s(EstimationMethod method, GateKind gate, const std::vector<estimation::JointSample>& samples,
               std::int64_t (*allocations_so_far)(), std::int64_t& allocations) {
  using Clock = std::chrono::steady_clock;
  const estimation::JointEstimator fresh = estimator(method, gate);
  double best = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kEstimatorsRounds; ++round) {
    estimation::JointEstimator estimates = fresh;
    const std::int64_t before = allocations_so_far != nullptr ? allocations_so_far() : 0;
    const auto start = Clock::now();
    for (const estimation::JointSample& sample : samples) {
      estimates.take(sample);
    }
    const std::chrono::duration<double> spent = Clock::now() - start;
    best = std::min(best, spent.count() / static_cast<double>(samples.size()));
    if (allocations_so_far != nullptr) {
      allocations += allocations_so_far() - before;
    }
    FARRIER_ENSURE(estimates.estimate().samples > 0, "an estimator that takes no sample is not timed");
  }
  return best;
}

}  // namespace

EstimatorsBench bench_estimators(int ticks, std::int64_t (*allocations_so_far)()) {
  const auto samples = make_samples(ticks);
  std::int64_t allocations = 0;
  const auto time = [&](EstimationMethod method, GateKind gate = GateKind::kNone) {
    return least_s(method, gate, samples, allocations_so_far, allocations);
  };
  EstimatorsBench bench{};
  bench.methods = {{{"rls", time(EstimationMethod::kRls)},
                    {"aff", time(EstimationMethod::kAff)},
                    {"kalman", time(EstimationMethod::kKalman)},
                    {"iv", time(EstimationMethod::kIv)},
                    {"vdf", time(EstimationMethod::kVdf)},
                    {"sift", time(EstimationMethod::kSift)}}};
  bench.pe_s = time(EstimationMethod::kRls, GateKind::kPe) - bench.methods[0].take_s;
  bench.fft_s = time(EstimationMethod::kRls, GateKind::kFft) - bench.methods[0].take_s;
  bench.allocations = allocations_so_far != nullptr ? allocations : -1;
  return bench;
}

}  // namespace farrier::bench
