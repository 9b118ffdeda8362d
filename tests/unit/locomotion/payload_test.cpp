#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/noise.hpp"
#include "locomotion/payload/payload_estimator.hpp"
#include "locomotion/rotation.hpp"
#include "tests/unit/locomotion/point_foot_robot.hpp"

namespace farrier::locomotion {
namespace payload_test {

using Eigen::Vector3d;

constexpr double kPeriod_s = 0.001;
constexpr double kRobot_kg = 80.0;
const Vector3d kCom_m{0.01, 0.0, -0.05};

/// The balance of a robot of 80 kg with a load.
class Loaded {
 public:
  explicit Loaded(const PayloadParams& params = {}) : estimator_(params, kRobot_kg, kPeriod_s) {}

  double load_kg = 0.0;
  Vector3d place_m = Vector3d::Zero();
  Vector3d up = Vector3d::UnitZ();
  double noise_N = 0.0;
  double missing_N = 0.0;                         // lift that the feet were asked for and do not give
  Vector3d missing_moment_Nm = Vector3d::Zero();  // likewise

  void go(double seconds, const Vector3d& acceleration_m_s2 = Vector3d::Zero(),
          const Vector3d& push_N = Vector3d::Zero()) {
    for (double t = 0.0; t < seconds; t += kPeriod_s) {
      estimator_.update(balance(acceleration_m_s2, push_N));
      estimator_.assume(kCom_m);
    }
  }

  ForceBalance balance(const Vector3d& acceleration_m_s2, const Vector3d& push_N) {
    const Vector3d specific = acceleration_m_s2 + kGravity_m_s2 * up;
    const Vector3d noise = noise_N * Vector3d(draw(), draw(), draw());
    const Vector3d force_N = (kRobot_kg + load_kg) * specific - push_N + noise;
    return {.force_N = force_N,
            .moment_Nm = (kRobot_kg * kCom_m + load_kg * place_m).cross(specific) - missing_moment_Nm,
            .specific_force_m_s2 = specific,
            .up = up,
            .com_m = kCom_m,
            .wanted_lift_N = up.dot(force_N) + missing_N};
  }

  PayloadEstimator& estimator() { return estimator_; }
  const Payload& payload() const { return estimator_.payload(); }
  const AssumedMass& assumed() const { return estimator_.assumed(); }

 private:
  double draw() { return 2.0 * draws_.uniform(tick_++) - 1.0; }

  PayloadEstimator estimator_;
  const NoiseStream draws_{1, "payload", "force"};
  Tick tick_ = 0;
};

TEST(PayloadEstimator, FindsMassAndPlaceOfALoad) {
  Loaded robot;
  robot.load_kg = 20.0;
  robot.place_m = {0.1, -0.05, 0.15};
  robot.go(20.0);
  EXPECT_NEAR(robot.payload().mass_kg, 20.0, 1e-3);
  EXPECT_LT((robot.payload().moment_kgm - Vector3d(2.0, -1.0, 0.0)).norm(), 1e-3);
  EXPECT_GT(robot.payload().validity, 0.999);
  EXPECT_NEAR(robot.assumed().mass_kg, 100.0, 1e-3);
  // (80 * 0.01 + 20 * 0.1) / 100 - 0.01, and -20 * 0.05 / 100
  EXPECT_LT((robot.assumed().shift_m - Vector3d(0.018, -0.01, 0.0)).norm(), 1e-4);
}

TEST(PayloadEstimator, FindsNineTenthsOfALoadInOneSecond) {
  Loaded robot;
  robot.load_kg = 20.0;
  robot.go(1.0);
  EXPECT_GT(robot.payload().mass_kg, 18.0);
  EXPECT_GT(robot.assumed().mass_kg, kRobot_kg + 18.0);
}

TEST(PayloadEstimator, FindsALoadOnASlopeAndInAccelerations) {
  Loaded robot;
  robot.load_kg = -8.0;
  robot.up = Vector3d(0.17, 0.0, 1.0).normalized();
  for (int stride = 0; stride < 20; ++stride) {
    robot.go(0.1, {0.0, 0.0, 3.0});
    robot.go(0.1, {0.0, 0.0, -3.0});
  }
  EXPECT_NEAR(robot.payload().mass_kg, -8.0, 0.05);
}

TEST(PayloadEstimator, KnowsItsErrorUnderNoise) {
  Loaded robot;
  robot.noise_N = 200.0;
  robot.go(4.0);
  EXPECT_GT(robot.payload().mass_error_kg, 0.1);
  EXPECT_LT(std::abs(robot.payload().mass_kg), 3.0 * robot.payload().mass_error_kg);
}

// 80 Ns in 0.1 s. Without its gate the estimate would take the lift of the trunk for a load.
TEST(PayloadEstimator, RestsUnderAPush) {
  Loaded robot;
  robot.go(2.0);
  const Vector3d push_N{0.0, 800.0, 200.0};
  robot.go(0.1, push_N / kRobot_kg, push_N);
  EXPECT_LT(std::abs(robot.assumed().mass_kg - kRobot_kg), 0.5);
  robot.go(1.0);
  EXPECT_LT(std::abs(robot.payload().mass_kg), 0.5);
}

// A weak supply leaves out 40 % of the lift, and 60 Nm by which the trunk tilts: they look like 76 mm of shift.
TEST(PayloadEstimator, RestsWhileTheFeetFallShort) {
  Loaded robot;
  robot.go(2.0);
  robot.missing_N = 0.4 * kRobot_kg * kGravity_m_s2;
  robot.missing_moment_Nm = {0.0, 60.0, 0.0};
  robot.go(2.0);
  EXPECT_LT(robot.assumed().shift_m.norm(), 0.006);
  robot.missing_N = 0.0;
  robot.go(2.0);
  EXPECT_GT(robot.assumed().shift_m.norm(), 0.03) << "a moment with full lift is a shift";
}

// Trunk and moment swing with the stride, 1.4 Hz. The assumed shift must not answer.
TEST(PayloadEstimator, LeavesTheSwingOfAStrideInTheMomentOut) {
  Loaded robot;
  constexpr double kSwing_Nm = 40.0, kStride_s = 0.7;
  for (double t = 0.0; t < 7.0; t += kPeriod_s) {
    robot.missing_moment_Nm.y() = kSwing_Nm * std::sin(2.0 * std::numbers::pi * t / kStride_s);
    robot.go(kPeriod_s);
    ASSERT_LT(robot.assumed().shift_m.norm(), 0.15 * kSwing_Nm / (kRobot_kg * kGravity_m_s2));
  }
}

TEST(PayloadEstimator, KeepsTheAssumedMassWithinItsLimitsAndRates) {
  const PayloadParams params;
  Loaded robot(params);
  robot.load_kg = 200.0;
  robot.place_m = {1.0, 0.0, 0.0};
  double before_kg = robot.assumed().mass_kg;
  for (int tick = 0; tick < 4000; ++tick) {
    robot.go(kPeriod_s);
    ASSERT_LE(robot.assumed().mass_kg - before_kg, params.largest_rate_1_s * kPeriod_s * kRobot_kg + 1e-9);
    before_kg = robot.assumed().mass_kg;
  }
  EXPECT_NEAR(robot.assumed().mass_kg, (1.0 + params.largest_share) * kRobot_kg, 1e-9);
  EXPECT_NEAR(robot.assumed().shift_m.x(), params.largest_shift_m, 1e-9);
  robot.load_kg = -79.0;
  robot.go(20.0);
  EXPECT_NEAR(robot.assumed().mass_kg, (1.0 + params.least_share) * kRobot_kg, 1e-9);
}

TEST(PayloadEstimator, LeavesOutNumbersThatAreNotFinite) {
  Loaded robot;
  robot.load_kg = 10.0;
  robot.go(4.0);
  ForceBalance bad = robot.balance(Vector3d::Zero(), Vector3d::Zero());
  bad.force_N.x() = std::numeric_limits<double>::quiet_NaN();
  robot.estimator().update(bad);
  bad = robot.balance(Vector3d::Zero(), Vector3d::Zero());
  bad.specific_force_m_s2.z() = std::numeric_limits<double>::infinity();
  robot.estimator().update(bad);
  robot.go(0.1);
  EXPECT_NEAR(robot.payload().mass_kg, 10.0, 0.01);
}

TEST(PayloadEstimator, AssumesTheModelWhenSwitchedOff) {
  PayloadParams params;
  params.on = false;
  Loaded robot(params);
  robot.load_kg = 20.0;
  robot.go(4.0);
  EXPECT_NEAR(robot.payload().mass_kg, 20.0, 0.01) << "the estimate is still published";
  EXPECT_EQ(robot.assumed().mass_kg, kRobot_kg);
}

// The robot's trunk has 78 kg. The controller is told of 20 kg less.
class OtherMass final : public BodyModel {
 public:
  explicit OtherMass(const PointFootRobot& robot) : robot_(robot) {}
  int leg_count() const noexcept override { return robot_.leg_count(); }
  double mass_kg() const noexcept override { return robot_.mass_kg() - 20.0; }
  void update(std::span<const LegReadings> legs, const TrunkMotion& trunk, BodyState& state) const noexcept override {
    robot_.update(legs, trunk, state);
  }

 private:
  const PointFootRobot& robot_;
};

TEST(TrotController, LearnsItsMassOnItsFeetAndForgetsItLying) {
  PointFootRobot robot(hyq_locomotion());
  const OtherMass model(robot);
  TrotController controller(hyq_locomotion(), robot.plan(), model);
  LegTorques torques;
  torques.fill(Vector3d::Zero());
  Tick now = 0;
  const auto go = [&](double seconds, const MotionCommand& command) {
    for (double t = 0.0; t < seconds; t += PointFootRobot::kPeriod_s) {
      const LegTorques next = controller.step(now++, robot.readings(), command);
      robot.step(torques);
      torques = next;
    }
  };
  go(2.5, {.request = Request::kLie});
  EXPECT_EQ(controller.state().payload.validity, 0.0);
  go(6.5, {.request = Request::kStand});
  EXPECT_NEAR(controller.state().payload.mass_kg, 20.0, 1.0);
  go(2.0, {.request = Request::kTrot, .forward_m_s = 0.3});
  double mean_kg = 0.0;
  constexpr int kTicks = 1000;
  for (int tick = 0; tick < kTicks; ++tick) {
    go(PointFootRobot::kPeriod_s, {.request = Request::kTrot, .forward_m_s = 0.3});
    mean_kg += controller.state().payload.mass_kg / kTicks;
  }
  EXPECT_NEAR(mean_kg, 20.0, 3.0);
  EXPECT_NEAR(robot.place_m().z(), hyq_locomotion().reference.default_height_m, 0.01);
  go(4.0, {.request = Request::kStand});
  go(5.0, {.request = Request::kLie});
  EXPECT_EQ(controller.state().mode, Mode::kLie);
  EXPECT_EQ(controller.state().assumed.mass_kg, model.mass_kg());
}

}  // namespace payload_test
}  // namespace farrier::locomotion
