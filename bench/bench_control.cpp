#include "bench/bench_control.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "control/law/force_controller.hpp"

namespace farrier::bench {
namespace {

constexpr int kControlRounds = 5;
constexpr double kControlPeriod_s = 1e-3;
constexpr control::Normalisation kNormalisation{0.04, 1.2, 5000.0, 0.01};

/// HyQ-like cylinder, 50 kg on it, 500 Ns/m, no spring: (3.51) in numbers, SI.
control::DiscreteModel leg_in_stance() {
  Eigen::Matrix3d a;
  a << 0.0, 1.0, 0.0, 0.0, -10.0, 0.02, 0.0, -6.4e6, -14.0;
  return control::discretise(a, Eigen::Vector3d(0.0, 0.0, 7.1e8), kControlPeriod_s);
}

template <class Work>
double seconds_per_call(int calls, const Work& work) {
  using Clock = std::chrono::steady_clock;
  double best = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kControlRounds; ++round) {
    const auto start = Clock::now();
    for (int i = 0; i < calls; ++i) {
      work(i);
    }
    best = std::min(best, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return best / calls;
}

}  // namespace

ControlBench bench_control(int steps, std::int64_t (*allocations_so_far)()) {
  steps = std::max(steps, 1);
  const control::DiscreteModel model = leg_in_stance();
  const control::Gains gains =
      control::design_lqr(model, {}, kNormalisation, control::Form::kCompliant, 1).value();
  const std::int64_t before = allocations_so_far != nullptr ? allocations_so_far() : 0;

  control::ForceController controller;
  controller.set_gains(gains, {0.0, 0.0, 0.0}, 0.0);
  control::Measurement measured{0.0, 0.0, 0.0};
  double last_current_A = 0.0;
  ControlBench bench{};
  bench.step_s = seconds_per_call(steps, [&](int i) {
    const double reference = (i & 64) != 0 ? 80.0 : -80.0;
    const double current_A = controller.step(reference, measured).valve_current_A;
    const Eigen::Vector3d next =
        model.a * Eigen::Vector3d(0.0, measured.velocity, measured.force) + model.b * last_current_A;
    measured = {0.0, next(1), next(2)};
    last_current_A = current_A;
  });
  bench.gain_change_s =
      seconds_per_call(steps, [&](int i) { controller.set_gains(gains, measured, (i & 1) != 0 ? 1.0 : 0.0); });
  volatile double sink = 0.0;
  bench.design_s = seconds_per_call(std::max(steps / 100, 1), [&](int) {
    sink = control::design_lqr(model, {}, kNormalisation, control::Form::kCompliant, 1).value().force;
  });
  static_cast<void>(sink);
  bench.allocations = allocations_so_far != nullptr ? allocations_so_far() - before : -1;
  return bench;
}

}  // namespace farrier::bench
