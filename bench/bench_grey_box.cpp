#include "bench/bench_grey_box.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <vector>

#include "core/ensure.hpp"
#include "core/noise.hpp"
#include "estimation/grey_box_estimator.hpp"
#include "plant/hydraulic_joint.hpp"
#include "plant/nominal.hpp"

namespace farrier::bench {
namespace {


constexpr int kGreyBoxRounds = 10;
constexpr double kHome_m = 0.04;
constexpr double kLoads_kg[] = {10.0, 100.0, 1.0, 2.0};

plant::LoadParams load(double mass_kg) {
  return {.mass = mass_kg, .damping = 700, .stiffness = 21480, .equilibrium_position = kHome_m};
}

std::vector<estimation::JointSample> grey_box_samples(int ticks) {
  const plant::LoadParams first = load(kLoads_kg[0]);
  plant::HydraulicJoint joint =
      plant::HydraulicJoint::create(plant::nominal_cylinder(), first, plant::equilibrium(plant::nominal_cylinder(), first, kHome_m, 0.0)).value();
  const NoiseStream valve(1, "valve", "");
  std::vector<estimation::JointSample> samples;
  for (Tick k = 0; k < ticks; ++k) {
    if (k % 250 == 0) {
      FARRIER_ENSURE(joint.set_load(load(kLoads_kg[k / 250 % 4])), "the loads are those of this file");
    }
    const plant::State& s = joint.state();
    estimation::JointSample sample{.tick = k, .state = {}, .current_A = 0.01 * (2.0 * valve.uniform(k) - 1.0), .phase = 0};
    sample.state << s.position, s.velocity, joint.load_cell_force();
    samples.push_back(sample);
    (void)joint.step(sample.current_A, 0.0, 1e-3);
  }
  return samples;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

GreyBoxBench bench_grey_box(int ticks, std::int64_t (*allocations_so_far)()) {
  const auto samples = grey_box_samples(std::max(ticks, 250));
  const estimation::JointScales scales{.state = {0.04, 1.2, 5000.0},
                                       .current_A = 0.01,
                                       .sensor_noise = {2e-6, 1.5e-3, 1.0},
                                       .home_position = kHome_m,
                                       .period_s = 1e-3,
                                       .input_delay_ticks = 0};
  const estimation::GreyBoxEstimator fresh =
      estimation::GreyBoxEstimator::create({}, scales, plant::nominal_cylinder(), {load(1.0), load(100.0)}).value();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  GreyBoxBench bench{kInfinity, kInfinity, kInfinity, 0};
  for (int round = 0; round < kGreyBoxRounds; ++round) {
    estimation::GreyBoxEstimator estimator = fresh;
    const std::int64_t before = allocations_so_far != nullptr ? allocations_so_far() : 0;
    double slowest = 0.0;
    const auto start = std::chrono::steady_clock::now();
    for (const estimation::JointSample& sample : samples) {
      const auto tick = std::chrono::steady_clock::now();
      estimator.take(sample);
      slowest = std::max(slowest, seconds_since(tick));
    }
    bench.take_s = std::min(bench.take_s, seconds_since(start) / static_cast<double>(samples.size()));
    bench.take_slowest_s = std::min(bench.take_slowest_s, slowest);
    constexpr int kEstimates = 200;
    double sum = 0.0;
    const auto estimates = std::chrono::steady_clock::now();
    for (int i = 0; i < kEstimates; ++i) {
      sum += estimator.estimate().physics.load_mass;
    }
    bench.estimate_s = std::min(bench.estimate_s, seconds_since(estimates) / kEstimates);
    FARRIER_ENSURE(sum > 0.0, "a mass is positive");
    bench.allocations += allocations_so_far != nullptr ? allocations_so_far() - before : 0;
  }
  bench.allocations = allocations_so_far != nullptr ? bench.allocations : -1;
  return bench;
}

}  // namespace farrier::bench
