#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/noise.hpp"
#include "locomotion/attitude_filter.hpp"
#include "locomotion/base_estimator.hpp"
#include "locomotion/rotation.hpp"
#include "tests/support/allocation_guard.hpp"

namespace farrier::locomotion {
namespace estimation_test {

constexpr double kPeriod_s = 0.001;
constexpr double kDegree = std::numbers::pi / 180.0;
// Xsens MTi-1 as tabulated in Trans. Aerospace Research (2023), 10.2478/tar-2023-0022: white noise per sample at 1 kHz.
constexpr double kGyroNoise_rad_s = 0.007 * kDegree * 31.62;
constexpr double kAccelerometerNoise_m_s2 = 120e-6 * kGravity_m_s2 * 31.62;

// Three independent normal numbers by tick.
class Noise {
 public:
  explicit Noise(const char* name) : x_(1, name, "x"), y_(1, name, "y"), z_(1, name, "z") {}
  Eigen::Vector3d at(Tick tick) const { return {x_.normal(tick), y_.normal(tick), z_.normal(tick)}; }

 private:
  NoiseStream x_, y_, z_;
};

TEST(Rotation, ByAVectorIsOrthonormalAndInvertible) {
  for (const double angle : {0.0, 1e-9, 1e-5, 0.3, 2.0}) {
    const Eigen::Vector3d vector = angle * Eigen::Vector3d{0.6, -0.48, 0.64};
    const Eigen::Matrix3d rotation = rotation_by(vector);
    EXPECT_LT((rotation * rotation_by(-vector) - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_LT((sine_vector(rotation) - std::sin(angle) * Eigen::Vector3d{0.6, -0.48, 0.64}).norm(), 1e-14);
  }
}

TEST(AttitudeFilter, FindsRollAndPitchWithinBoundsInSpiteOfABias) {
  AttitudeFilter filter({}, kPeriod_s);
  const Noise gyro("gyro"), accelerometer("accelerometer");
  const Eigen::Vector3d bias = 0.2 * kDegree * Eigen::Vector3d{1.0, -1.0, 0.5};
  Eigen::Matrix3d truth = rotation_by({0.1, -0.05, 0.0});
  filter.reset(truth.transpose() * Eigen::Vector3d{0.0, 0.0, kGravity_m_s2});
  double worst = 0.0;
  for (Tick tick = 0; tick < 240000; ++tick) {
    const double t = static_cast<double>(tick) * kPeriod_s;
    const Eigen::Vector3d rate = 0.3 * Eigen::Vector3d{std::sin(9.0 * t), std::cos(7.0 * t), 0.1};
    truth = orthonormalised(truth * rotation_by(kPeriod_s * rate));
    filter.update(
        {rate + bias + kGyroNoise_rad_s * gyro.at(tick), truth.transpose() * Eigen::Vector3d{0.0, 0.0, kGravity_m_s2} +
                                                             kAccelerometerNoise_m_s2 * accelerometer.at(tick)},
        Eigen::Vector3d::Zero(), false);
    if (t > 200.0) {
      worst = std::max(worst, (filter.rotation().row(2) - truth.row(2)).norm());
    }
  }
  EXPECT_LT(worst, 0.15 * kDegree);
}

TEST(AttitudeFilter, LearnsTheBiasWhileStandingStill) {
  AttitudeFilter filter({}, kPeriod_s);
  const Noise gyro("gyro");
  const Eigen::Vector3d bias = 0.2 * kDegree * Eigen::Vector3d{1.0, -1.0, 0.5};
  const Eigen::Vector3d gravity{0.0, 0.0, kGravity_m_s2};
  filter.reset(gravity);
  for (Tick tick = 0; tick < 5000; ++tick) {
    filter.update({bias + kGyroNoise_rad_s * gyro.at(tick), gravity}, Eigen::Vector3d::Zero(), true);
    // the feet stand, so the world turns with the whole rate and with the filter's correction, which is zero here
    filter.correct_bias(filter.angular_velocity_rad_s(), true);
  }
  // standard deviation of the mean: 0.007 deg/s/sqrt(Hz) over 5 s; three of them on each axis
  EXPECT_LT((filter.bias_rad_s() - bias).cwiseAbs().maxCoeff(), 3.0 * 0.007 * kDegree / std::sqrt(5.0));
}

// A trunk that trots: diagonal pairs stand in turn for 0.36 s, the trunk bounces, sways and moves forward.
class SyntheticTrot {
 public:
  static constexpr double kHalfStride_s = 0.36;

  Eigen::Vector3d position(double t) const {
    return {0.4 * t, 0.01 * std::sin(kW * t), 0.58 + 0.01 * std::sin(2 * kW * t)};
  }
  Eigen::Vector3d velocity(double t) const {
    return {0.4, 0.01 * kW * std::cos(kW * t), 0.02 * kW * std::cos(2 * kW * t)};
  }
  Eigen::Vector3d acceleration(double t) const {
    return {0.0, -0.01 * kW * kW * std::sin(kW * t), -0.04 * kW * kW * std::sin(2 * kW * t)};
  }
  double progress(int leg, double t) const {
    const double strides = t / kHalfStride_s;
    const bool pair = (static_cast<int>(strides) + (leg == 0 || leg == 3 ? 0 : 1)) % 2 == 0;
    return pair ? strides - std::floor(strides) : -1.0;
  }
  // where the foot stands that touched down last
  Eigen::Vector3d foot(int leg, double t) const {
    const double began = kHalfStride_s * std::floor(t / kHalfStride_s);
    return Eigen::Vector3d{position(began + 0.5 * kHalfStride_s).x(), 0.0, 0.0} +
           Eigen::Vector3d{leg < 2 ? 0.37 : -0.37, leg % 2 == 0 ? 0.3 : -0.3, 0.0};
  }

 private:
  static constexpr double kW = std::numbers::pi / kHalfStride_s;
};

struct Errors {
  double velocity_m_s, drift;
};

Errors run_trot(double slip_m_s) {
  const SyntheticTrot trot;
  BaseEstimator estimator({}, 4, kPeriod_s);
  const Noise accelerometer("accelerometer");
  const Noise feet_noise[4] = {Noise("lf"), Noise("rf"), Noise("lh"), Noise("rh")};
  PerLeg<FootMeasurement> feet;
  Errors errors{0.0, 0.0};
  Eigen::Vector3d start;
  constexpr Tick kRun = 30000;
  for (Tick tick = 0; tick <= kRun; ++tick) {
    const double t = static_cast<double>(tick) * kPeriod_s;
    for (int leg = 0; leg < 4; ++leg) {
      const double slipped = leg == 0 && trot.progress(leg, t) > 0.4 ? slip_m_s : 0.0;
      feet[leg] = {
          .position_m = trot.foot(leg, t) - trot.position(t),
          .velocity_m_s = -trot.velocity(t) + 0.015 * feet_noise[leg].at(tick) + Eigen::Vector3d{slipped, 0, 0},
          .rolling_m_s = Eigen::Vector3d::Zero(),
          .trust = estimator.trust(trot.progress(leg, t))};
    }
    if (tick == 0) {
      estimator.reset(trot.position(0.0), feet);
      start = estimator.position_m() - trot.position(0.0);
      continue;
    }
    estimator.update(trot.acceleration(t - 0.5 * kPeriod_s) + kAccelerometerNoise_m_s2 * accelerometer.at(tick) +
                         Eigen::Vector3d{0.02, 0.0, 0.02},  // 2 mg of bias
                     feet);
    if (t > 2.0) {
      errors.velocity_m_s = std::max(errors.velocity_m_s, (estimator.velocity_m_s() - trot.velocity(t)).norm());
    }
    if (tick == kRun) {
      errors.drift = (estimator.position_m() - trot.position(t) - start).norm() / trot.position(t).x();
    }
  }
  return errors;
}

TEST(BaseEstimator, FollowsATrotByItsFeetAndAccelerometer) {
  const Errors errors = run_trot(0.0);
  EXPECT_LT(errors.velocity_m_s, 0.05);
  EXPECT_LT(errors.drift, 0.01);  // of the distance
}

TEST(BaseEstimator, DisbelievesAFootThatSlipsFast) {
  const Errors errors = run_trot(2.0);
  EXPECT_LT(errors.velocity_m_s, 0.1);
  EXPECT_LT(errors.drift, 0.02);
}

TEST(BaseEstimator, TrustRampsAtBothEndsOfTheStance) {
  const BaseEstimator estimator({.trust_ramp = 0.2}, 4, kPeriod_s);
  EXPECT_EQ(estimator.trust(-1.0), 0.0);
  EXPECT_EQ(estimator.trust(0.0), 0.0);
  EXPECT_DOUBLE_EQ(estimator.trust(0.1), 0.5);
  EXPECT_EQ(estimator.trust(0.5), 1.0);
  EXPECT_NEAR(estimator.trust(0.95), 0.25, 1e-12);
}

TEST(BaseEstimator, AllocatesNothing) {
  BaseEstimator estimator({}, 4, kPeriod_s);
  PerLeg<FootMeasurement> feet;
  feet.fill({Eigen::Vector3d{0.3, 0.2, -0.5}, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 1.0});
  estimator.reset(Eigen::Vector3d::Zero(), feet);
  const test::AllocationGuard guard;
  estimator.update(Eigen::Vector3d::Zero(), feet);
  EXPECT_EQ(guard.allocations(), 0u);
}

}  // namespace estimation_test
}  // namespace farrier::locomotion
