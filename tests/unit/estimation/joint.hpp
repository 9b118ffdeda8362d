#pragma once

// A joint that is exactly linear, as large as a knee of HyQ, and what drives it.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "estimation/joint_estimator.hpp"
#include "data.hpp"

namespace farrier::estimation::testing {

inline constexpr double kPeriod_s = 0.001;
inline constexpr double kDither_A = 2e-5;  // a fifth of a percent of the valve's nominal current
inline constexpr double kSwingMass_kg = 5.0, kStanceMass_kg = 40.0;
inline const Eigen::Vector3d kNoNoise = Eigen::Vector3d::Zero();
inline const Eigen::Vector3d kHyqNoise(2e-6, 1.5e-3, 1.0);  // hyq.yaml: m, m/s, N
inline constexpr double kHome_m = 0.04;

struct LinearModel {
  Eigen::Matrix3d a;
  Eigen::Vector3d b;
};

/// A mass with friction and a load spring, moved by oil (Hubacher 2014, (3.43)-(3.51) with numbers of HyQ's cylinder),
/// sampled; position is summed velocity.
inline LinearModel linear_joint(double mass_kg, double spring_N_m = 0.0, double valve_factor = 1.0) {
  constexpr double kLoad_Ns_m = 500.0, kPiston_Ns_m = 700.0, kOil_N_m = 6.6e6, kValve_N_sA = 7.3e8;
  Eigen::Matrix4d rate = Eigen::Matrix4d::Zero();
  rate.row(0) << 0.0, 1.0, 0.0, 0.0;
  rate.row(1) << -spring_N_m / mass_kg, -kLoad_Ns_m / mass_kg, 1.0 / mass_kg, 0.0;
  rate.row(2) << kPiston_Ns_m * spring_N_m / mass_kg, kPiston_Ns_m * kLoad_Ns_m / mass_kg - kOil_N_m,
      -kPiston_Ns_m / mass_kg, valve_factor * kValve_N_sA;
  Eigen::Matrix4d term = Eigen::Matrix4d::Identity(), sampled = term;
  for (int i = 1; i < 60; ++i) {
    term *= rate * kPeriod_s / i;
    sampled += term;
  }
  LinearModel model{sampled.topLeftCorner<3, 3>(), sampled.topRightCorner<3, 1>()};
  model.a.row(0) << 1.0, kPeriod_s, 0.0;
  model.b(0) = 0.0;
  return model;
}

inline JointScales scales(const Eigen::Vector3d& noise = kNoNoise, int delay_ticks = 0) {
  return {.state = {0.04, 1.2, 5000.0},
          .current_A = 0.01,
          .sensor_noise = noise,
          .home_position = kHome_m,
          .period_s = kPeriod_s,
          .input_delay_ticks = delay_ticks};
}

inline JointEstimator estimator(const EstimatorParams& params = {}, const JointScales& with = scales()) {
  const LinearModel prior = linear_joint(kSwingMass_kg);
  return JointEstimator::create(params, with, prior.a, prior.b).value();
}

/// A joint in a loop: current = dither + force_gain (0 - F as measured); whatever else pushes it is `push_N`.
class Joint {
 public:
  explicit Joint(const LinearModel& model, std::uint64_t seed = 1) : model_(model), seed_(seed) {}

  Joint& measured_with(const Eigen::Vector3d& noise) { noise_ = noise; return *this; }
  Joint& closed_with(double gain_A_N) { gain_A_N_ = gain_A_N; return *this; }
  Joint& commanded_late(int ticks) { delay_ticks_ = ticks; return *this; }
  Joint& dithered_with(double current_A, int hold_ticks = 1) {
    dither_A_ = current_A;
    hold_ticks_ = hold_ticks;
    return *this;
  }

  /// The sample of the next tick. `push_N` acts on the load from that tick on, with the mass of the joint's model.
  JointSample next(int phase = 0, double push_N = 0.0, double mass_kg = kSwingMass_kg) {
    JointSample sample;
    sample.tick = tick_;
    sample.phase = phase;
    sample.state = state_ + noise_.cwiseProduct(normal<3>(seed_, "sensor", tick_));
    const double sign = normal<1>(seed_, "dither", tick_ / hold_ticks_)(0) > 0.0 ? 1.0 : -1.0;
    sample.current_A = dither_A_ * sign - gain_A_N_ * sample.state(2);
    sample.state(0) += kHome_m;
    currents_.push_back(sample.current_A);
    const auto late = static_cast<std::size_t>(delay_ticks_);
    const double acting = currents_.size() > late ? currents_[currents_.size() - 1 - late] : 0.0;
    state_ = model_.a * state_ + model_.b * acting + Eigen::Vector3d(0.0, kPeriod_s * push_N / mass_kg, 0.0);
    ++tick_;
    return sample;
  }

  void becomes(const LinearModel& model) { model_ = model; }
  Tick tick() const { return tick_; }

 private:
  LinearModel model_;
  std::uint64_t seed_;
  Eigen::Vector3d noise_ = kNoNoise;
  double gain_A_N_ = 0.0, dither_A_ = kDither_A;
  int delay_ticks_ = 0, hold_ticks_ = 1;
  Tick tick_ = 0;
  Eigen::Vector3d state_ = Eigen::Vector3d::Zero();
  std::vector<double> currents_;
};

inline void feed(JointEstimator& estimator, Joint& joint, int ticks, int phase = 0) {
  for (int k = 0; k < ticks; ++k) {
    estimator.take(joint.next(phase));
  }
}

/// Largest error of rows velocity and force of A (position's column only when `position`) and B, in normalised units.
inline double error(const ModelEstimate& estimate, const LinearModel& truth, bool position = false) {
  const JointScales s = scales();
  const Eigen::Matrix3d a = s.state.cwiseInverse().asDiagonal() * (estimate.a - truth.a) * s.state.asDiagonal();
  const Eigen::Vector3d b = s.current_A * (estimate.b - truth.b).cwiseQuotient(s.state);
  const int first = position ? 0 : 1;
  return std::max(a.block(1, first, 2, 3 - first).cwiseAbs().maxCoeff(), b.tail<2>().cwiseAbs().maxCoeff());
}

inline bool has(const ModelEstimate& estimate, EstimateFlag flag) {
  return (estimate.flags & static_cast<std::uint32_t>(flag)) != 0;
}

}  // namespace farrier::estimation::testing
