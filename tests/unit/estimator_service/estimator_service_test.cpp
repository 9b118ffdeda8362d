#include "estimator_service/estimator_service.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/noise.hpp"
#include "robot/joint_effects.hpp"
#include "robot/joint_model.hpp"
#include "tests/support/allocation_guard.hpp"
#include "tests/unit/robot/test_files.hpp"

namespace farrier::estimator_service {
namespace estimator_service_test {

using signals::JointMeasurement;
using signals::JointModelEstimate;

constexpr int kNoDelay = 0;
constexpr std::uint16_t kKnee = 2, kOtherKnee = 5;
constexpr auto kSwing = signals::Phase::kSwing;
constexpr auto kStance = signals::Phase::kStance;
constexpr Tick kEnough = 4000;       // eight times what 0.998 remembers
constexpr double kExcitation = 0.2;  // of the valve's nominal current

/// Without sensor noise, so that what is left is the algorithm.
const robot::Robot& hyq() {
  static const robot::Robot robot = [] {
    robot::Robot shipped = robot::load_shipped("hyq", {.without_effects = true});
    for (robot::Joint& joint : shipped.joints) {
      joint.noise = {};
    }
    return shipped;
  }();
  return robot;
}

TEST(TakenTicks, HasABitForEachOfTheLast64Ticks) {
  TakenTicks taken;
  EXPECT_EQ(taken.bits_at(0), 0u);
  taken.add(0);
  EXPECT_EQ(taken.bits_at(0), 1u);
  taken.add(1);
  taken.add(4);
  EXPECT_EQ(taken.bits_at(4), 0b11001u);
  taken.add(3);  // late
  EXPECT_EQ(taken.bits_at(4), 0b11011u);
  EXPECT_EQ(taken.bits_at(6), 0b1101100u);
  taken.add(100);
  EXPECT_EQ(taken.bits_at(100), 1u);
}

EstimatorService service(int delay_ticks = kNoDelay) { return EstimatorService::create(hyq(), delay_ticks).value(); }

/// Measurements of a joint that is exactly the linear model of its load. White noise drives the valve.
class LinearJoint {
 public:
  LinearJoint(std::uint16_t number, const control::DiscreteModel& model, signals::Phase phase = kSwing)
      : joint_(hyq().joints[number]), model_(model), phase_(phase), valve_(7, joint_.name, "valve") {}

  JointMeasurement next() {
    const double sign = valve_.normal(tick_) > 0.0 ? 1.0 : -1.0;
    const double current = kExcitation * joint_.actuator.valve_current_max_A * sign;
    const JointMeasurement measurement{.joint = joint_.number,
                                       .tick = tick_++,
                                       .position_m_or_rad = joint_.linkage.position(joint_.home_angle_rad) + state_(0),
                                       .velocity_m_s_or_rad_s = state_(1),
                                       .force_N_or_Nm = state_(2),
                                       .valve_current_A = current,
                                       .phase = phase_};
    state_ = model_.a * state_ + model_.b * current;
    return measurement;
  }

 private:
  const robot::Joint& joint_;
  control::DiscreteModel model_;
  signals::Phase phase_;
  NoiseStream valve_;
  Tick tick_ = 0;
  Eigen::Vector3d state_ = Eigen::Vector3d::Zero();
};

control::DiscreteModel heavy_knee() {
  return robot::model_of(hyq().joints[kKnee], hyq().joints[kKnee].stance_load, hyq().period_s);
}

JointModelEstimate estimate_of(EstimatorService& estimators, LinearJoint joint, std::uint16_t number, Tick ticks) {
  for (Tick tick = 0; tick < ticks; ++tick) {
    estimators.take(joint.next());
  }
  return estimators.estimate(number, ticks - 1);
}

double relative_error(double value, double truth) { return std::abs(value / truth - 1.0); }

// Least squares on exact data. The error left is the prior's weight 1e-5, of which 0.998^4000 = 3e-4 remains, over the
// information. This is 500 samples of full weight, (6e-3)^2, a tenth of it in the weakest direction.
constexpr double kExact = 1e-5;
// A sample that is missing moves the mean by an eighth of itself for a dozen ticks of the 500 that are remembered.
constexpr double kOneMissing = 1e-3;

TEST(EstimatorService, EstimatesTheLoadAJointCarries) {
  EstimatorService estimators = service();
  const control::DiscreteModel truth = heavy_knee();
  const JointModelEstimate estimate = estimate_of(estimators, {kKnee, truth}, kKnee, kEnough);
  EXPECT_GT(estimate.validity, 0.9);
  EXPECT_LT(relative_error(estimate.b[2], truth.b(2)), kExact);
  for (const std::size_t place : {4u, 5u, 7u, 8u}) {
    const auto row = static_cast<int>(place / 3), column = static_cast<int>(place % 3);
    EXPECT_LT(relative_error(estimate.a[place], truth.a(row, column)), kExact) << place << ": row by row";
  }
  EXPECT_EQ(estimate.a[0], 1.0) << "position is summed velocity";
  EXPECT_NEAR(estimate.a[1], hyq().period_s, 1e-15);
  EXPECT_GT(estimate.samples, 0u);
  EXPECT_GT(estimate.excitation, 0.0);
}

/// The current that the joint's own node sends for an opening, and the force that a filtered sensor reads.
JointMeasurement as_sent_and_read(JointMeasurement ideal, double overlap_A, control::LowPass& force_filter) {
  ideal.valve_current_A += std::copysign(overlap_A, ideal.valve_current_A);
  ideal.force_N_or_Nm = force_filter.take(ideal.force_N_or_Nm);
  return ideal;
}

TEST(EstimatorService, ReadsTheValvesOpeningAndAlignsFilteredSensors) {
  constexpr double kOverlap_A = 2e-4;
  robot::Robot robot = hyq();
  robot::Joint& knee = robot.joints[kKnee];
  knee = robot::with_effects(knee, std::vector{plant::ActiveEffect{plant::find_effect("valve_deadband"), {kOverlap_A}}})
             .value();
  knee.sensors.force = {.cut_off_Hz = 150.0};
  EstimatorService estimators = EstimatorService::create(robot, kNoDelay).value();
  const control::DiscreteModel truth = heavy_knee();
  LinearJoint joint(kKnee, truth);
  control::LowPass filter(control::design_low_pass(knee.sensors.force, 1.0 / robot.period_s).value());
  for (Tick tick = 0; tick < kEnough; ++tick) {
    estimators.take(as_sent_and_read(joint.next(), kOverlap_A, filter));
  }
  const JointModelEstimate estimate = estimators.estimate(kKnee, kEnough - 1);
  EXPECT_LT(relative_error(estimate.b[2], truth.b(2)), 1e-3);
  EXPECT_LT(relative_error(estimate.a[8], truth.a(2, 2)), 1e-3);
}

TEST(EstimatorService, AnswersForTheJointTickAndPhaseItWasAskedFor) {
  EstimatorService estimators = service();
  estimators.take({.joint = 7, .tick = 1300, .phase = kStance});
  const JointModelEstimate estimate = estimators.estimate(7, 1300);
  EXPECT_EQ(estimate.joint, 7);
  EXPECT_EQ(estimate.tick, 1300);
  EXPECT_EQ(estimate.phase, kStance);
  estimators.take({.joint = 7, .tick = 1301, .phase = kSwing});
  EXPECT_EQ(estimators.estimate(7, 1301).phase, kSwing);
}

TEST(EstimatorService, BeginsWithTheSwingLoadAndSaysThatItIsNotAnEstimate) {
  const EstimatorService estimators = service();
  for (const robot::Joint& joint : hyq().joints) {
    const JointModelEstimate estimate = estimators.estimate(joint.number, 0);
    const control::DiscreteModel prior = robot::model_of(joint, joint.swing_load, hyq().period_s);
    EXPECT_EQ(estimate.validity, 0.0);
    EXPECT_NE(estimate.flags & static_cast<std::uint32_t>(estimation::EstimateFlag::kNotYetSet), 0u);
    EXPECT_LT(relative_error(estimate.b[2], prior.b(2)), 1e-12) << joint.name;
    EXPECT_LT(relative_error(estimate.a[8], prior.a(2, 2)), 1e-12) << joint.name;
  }
}

TEST(EstimatorService, KeepsTheJointsApart) {
  EstimatorService alone = service(), together = service();
  LinearJoint knee(kKnee, heavy_knee()), same_knee(kKnee, heavy_knee());
  const robot::Joint& right = hyq().joints[kOtherKnee];
  LinearJoint other(kOtherKnee, robot::model_of(right, right.swing_load, hyq().period_s));
  for (Tick tick = 0; tick < kEnough; ++tick) {
    alone.take(knee.next());
    together.take(other.next());
    together.take(same_knee.next());
  }
  const JointModelEstimate a = alone.estimate(kKnee, kEnough), b = together.estimate(kKnee, kEnough);
  EXPECT_EQ(a.a, b.a);
  EXPECT_EQ(a.b, b.b);
  EXPECT_EQ(a.samples, b.samples);
  EXPECT_EQ(alone.estimate(kOtherKnee, kEnough).samples, 0u);
}

TEST(EstimatorService, KnowsTheDelayOfTheLoop) {
  for (const int delay_ticks : {0, 1, 2}) {
    EstimatorService right = service(delay_ticks), wrong = service((delay_ticks + 1) % 3);
    const control::DiscreteModel truth = heavy_knee();
    LinearJoint joint(kKnee, truth);
    std::vector<JointMeasurement> sent;
    for (Tick tick = 0; tick < kEnough; ++tick) {
      sent.push_back(joint.next());
    }
    // The current that acts from tick k on was asked for delay_ticks before.
    for (std::size_t k = 0; k + 2 < sent.size(); ++k) {
      JointMeasurement measurement = sent[k];
      measurement.valve_current_A = sent[k + static_cast<std::size_t>(delay_ticks)].valve_current_A;
      right.take(measurement);
      wrong.take(measurement);
    }
    EXPECT_LT(relative_error(right.estimate(kKnee, kEnough).b[2], truth.b(2)), kExact) << delay_ticks;
    EXPECT_GT(relative_error(wrong.estimate(kKnee, kEnough).b[2], truth.b(2)), 0.5) << delay_ticks;
  }
}

TEST(EstimatorService, IsUnharmedByAMeasurementThatIsNotFinite) {
  using Limits = std::numeric_limits<double>;
  const control::DiscreteModel truth = heavy_knee();
  for (const double bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
    for (double JointMeasurement::*field :
         {&JointMeasurement::position_m_or_rad, &JointMeasurement::velocity_m_s_or_rad_s,
          &JointMeasurement::force_N_or_Nm, &JointMeasurement::valve_current_A}) {
      EstimatorService estimators = service();
      LinearJoint joint(kKnee, truth);
      for (Tick tick = 0; tick < kEnough; ++tick) {
        JointMeasurement measurement = joint.next();
        if (tick == kEnough - 200) {
          measurement.*field = bad;
        }
        estimators.take(measurement);
      }
      EXPECT_LT(relative_error(estimators.estimate(kKnee, kEnough).b[2], truth.b(2)), kOneMissing);
    }
  }
}

TEST(EstimatorService, IgnoresAJointTheRobotDoesNotHave) {
  EstimatorService estimators = service();
  estimators.take({.joint = 200, .tick = 0});
  const JointModelEstimate nothing = estimators.estimate(200, 0);
  EXPECT_EQ(nothing.joint, 200);
  EXPECT_EQ(nothing.validity, 0.0);
  EXPECT_EQ(nothing.samples, 0u);
}

TEST(EstimatorService, RefusesEstimatorSettingsNamingTheJoint) {
  robot::Robot robot = hyq();
  robot.joints[4].estimator.operating_point_order = 9;
  const auto refused = EstimatorService::create(robot, kNoDelay);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message.find(robot.joints[4].name + ": operating_point_order"), 0u)
      << refused.error().message;
  EXPECT_FALSE(EstimatorService::create(hyq(), 3)) << "no command acts three ticks late";
}

TEST(EstimatorService, TakesAndEstimatesWithoutAllocation) {
  EstimatorService estimators = service();
  LinearJoint joint(kKnee, heavy_knee());
  double sum = 0.0;
  const test::AllocationGuard guard;
  for (Tick tick = 0; tick < 200; ++tick) {
    estimators.take(joint.next());
    estimators.take({.joint = 200, .tick = tick});
    sum += estimators.estimate(kKnee, tick).b[2] + estimators.estimate(200, tick).validity;
  }
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_TRUE(std::isfinite(sum));
}

}  // namespace estimator_service_test
}  // namespace farrier::estimator_service
