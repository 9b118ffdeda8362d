#include "estimator_service/estimator_service.hpp"

#include <limits>

#include "tests/support/allocation_guard.hpp"
#include "tests/unit/robot_test_files.hpp"

namespace farrier::estimator_service {
namespace {

using signals::JointMeasurement;

EstimatorService service() {
  static const robot::Robot hyq = robot::load_shipped("hyq");
  return EstimatorService(hyq);
}

TEST(EstimatorService, AnswersForTheJointTickAndPhaseItWasGiven) {
  EstimatorService estimators = service();
  constexpr auto kStance = static_cast<std::uint8_t>(signals::Phase::kStance);
  const auto estimate = estimators.step({.joint = 7, .tick = 1300, .phase = kStance});
  EXPECT_EQ(estimate.joint, 7);
  EXPECT_EQ(estimate.tick, 1300);
  EXPECT_EQ(estimate.phase, kStance);
  EXPECT_EQ(estimators.step({.joint = 7, .tick = 1301}).phase, static_cast<std::uint8_t>(signals::Phase::kSwing));
}

TEST(EstimatorService, SaysThatItDoesNotEstimate) {
  EstimatorService estimators = service();
  const auto estimate = estimators.step({.joint = 7, .tick = 0});
  EXPECT_EQ(estimate.validity, 0.0) << "not an estimate";
  EXPECT_EQ(estimate.flags, static_cast<std::uint32_t>(EstimateFlag::kNotEstimating));
}

TEST(EstimatorService, CountsTheMeasurementsOfEachJoint) {
  EstimatorService estimators = service();
  for (Tick tick = 0; tick < 5; ++tick) {
    estimators.step({.joint = 2, .tick = tick});
  }
  EXPECT_EQ(estimators.usable_measurements(2), 5u);
  EXPECT_EQ(estimators.usable_measurements(3), 0u);
}

TEST(EstimatorService, CountsNoMeasurementThatIsNotFinite) {
  using Limits = std::numeric_limits<double>;
  EstimatorService estimators = service();
  for (const double bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
    for (double JointMeasurement::*field :
         {&JointMeasurement::position_m_or_rad, &JointMeasurement::velocity_m_s_or_rad_s,
          &JointMeasurement::force_N_or_Nm}) {
      JointMeasurement measurement{.joint = 2, .tick = 0};
      measurement.*field = bad;
      EXPECT_EQ(estimators.step(measurement).validity, 0.0);
    }
  }
  EXPECT_EQ(estimators.usable_measurements(2), 0u);
}

TEST(EstimatorService, IgnoresAJointTheRobotDoesNotHave) {
  EstimatorService estimators = service();
  EXPECT_EQ(estimators.step({.joint = 200, .tick = 0}).validity, 0.0);
  EXPECT_EQ(estimators.usable_measurements(200), 0u);
}

TEST(EstimatorService, StepDoesNotAllocate) {
  EstimatorService estimators = service();
  const test::AllocationGuard guard;
  for (Tick tick = 0; tick < 100; ++tick) {
    estimators.step({.joint = static_cast<std::uint16_t>(tick % 12), .tick = tick});
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

}  // namespace
}  // namespace farrier::estimator_service
