#include "bench/bench_forgetting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/noise.hpp"
#include "estimation/joint_estimator.hpp"
#include "robot/joint_model.hpp"
#include "robot/make_estimator.hpp"

namespace farrier::bench {
namespace {

constexpr double kNotYet = std::numeric_limits<double>::infinity();
constexpr double kDriveShare = 0.02;  // of the valve's current
constexpr Tick kSwingTicks = 2000;
constexpr Tick kStanceTicks = 400;
constexpr Tick kWindow = 20;  // noise alone moves a factor by some hundredths

double growth_of(const robot::Joint& joint) { return joint.stance_load.mass / joint.swing_load.mass; }

const robot::Joint* most_changing(const robot::Robot& robot) {
  const robot::Joint* most = nullptr;
  for (const robot::Joint& joint : robot.joints) {
    if (!joint.electric && (most == nullptr || growth_of(joint) > growth_of(*most))) {
      most = &joint;
    }
  }
  return most;
}

Result<ForgettingBench> times_of(const robot::Joint& joint, double period_s, std::uint64_t seed) {
  const control::DiscreteModel swing = robot::model_of(joint, joint.swing_load, period_s);
  const control::DiscreteModel stance = robot::model_of(joint, joint.stance_load, period_s);
  const estimation::JointScales scales = robot::estimator_scales(joint, period_s, 0);
  estimation::EstimatorParams params;
  params.method = estimation::EstimationMethod::kAff;
  auto estimates = FARRIER_TRY(estimation::JointEstimator::create(params, scales, swing.a, swing.b));
  const NoiseStream drive(seed, joint.name, "drive");
  const NoiseStream sensors(seed, joint.name, "sensors");
  Eigen::Vector3d state = Eigen::Vector3d::Zero();
  ForgettingBench times{kNotYet, kNotYet};
  double sum = 0.0;
  for (Tick tick = 0; tick < kSwingTicks + kStanceTicks && times.return_s == kNotYet; ++tick) {
    estimation::JointSample sample;
    sample.tick = tick;
    for (int i = 0; i < 3; ++i) {
      sample.state(i) = state(i) + scales.sensor_noise(i) * sensors.normal(3 * tick + i);
    }
    sample.state(0) += scales.home_position;
    sample.current_A = std::copysign(kDriveShare * scales.current_A, drive.normal(tick));
    estimates.take(sample);
    const control::DiscreteModel& model = tick < kSwingTicks ? swing : stance;
    state = model.a * state + model.b * sample.current_A;
    if (tick <= kSwingTicks) {  // this sample is of the swing load still
      continue;
    }
    const double least = estimates.forgetting(0).minCoeff();
    const Tick since = tick - kSwingTicks;
    if (times.fall_s == kNotYet && least < kForgets) {
      times.fall_s = static_cast<double>(since) * period_s;
    }
    sum += least;
    if (since % kWindow == 0) {
      if (times.fall_s < kNotYet && sum / kWindow > kRemembers) {
        times.return_s = static_cast<double>(since) * period_s;
      }
      sum = 0.0;
    }
  }
  return times;
}

}  // namespace

Result<ForgettingBench> bench_forgetting(const robot::Robot& robot, int seeds) {
  const robot::Joint* joint = most_changing(robot);
  if (joint == nullptr) {
    return Error{"forgetting: " + robot.name + " has no hydraulic joint"};
  }
  ForgettingBench slowest{0.0, 0.0};
  for (int seed = 1; seed <= seeds; ++seed) {
    const ForgettingBench times = FARRIER_TRY(times_of(*joint, robot.period_s, static_cast<std::uint64_t>(seed)));
    slowest.fall_s = std::max(slowest.fall_s, times.fall_s);
    slowest.return_s = std::max(slowest.return_s, times.return_s);
  }
  return slowest;
}

}  // namespace farrier::bench
