// The memory of a joint's estimator, and when its estimate is valid.

#include <gtest/gtest.h>

#include "joint.hpp"

namespace farrier::estimation {
namespace joint_memory_test {

using namespace testing;

constexpr int kSwing = 0, kStance = 1;
constexpr int kEnough = 3000;
constexpr double kExact = 1e-3;  // as in estimation_joint_test.cpp
// One or two missing samples shift the mean by up to 1 - (5/6)^2 of itself for a dozen ticks of the 500 that are
// remembered. The bound is a tenth of the distance of poles that counts as a change.
constexpr double kBridged = 0.01;

EstimatorParams without_position() {
  EstimatorParams params;
  params.position = false;
  return params;
}

/// Samples without information: the joint does not move, and its valve is shut.
JointSample still(Tick tick, int phase = kSwing) {
  return {.tick = tick, .state = {kHome_m, 0.0, 0.0}, .current_A = 0.0, .phase = phase};
}

TEST(JointEstimator, KeepsThePhasesApart) {
  JointEstimator estimates = estimator(without_position());
  Joint joint(linear_joint(kSwingMass_kg));
  for (int stride = 0; stride < 10; ++stride) {
    joint.becomes(linear_joint(kSwingMass_kg));
    feed(estimates, joint, 250, kSwing);
    EXPECT_EQ(estimates.estimate().phase, kSwing);
    if (stride > 0) {
      EXPECT_LT(error(estimates.estimate(), linear_joint(kSwingMass_kg)), kExact) << stride;
    }
    joint.becomes(linear_joint(kStanceMass_kg));
    feed(estimates, joint, 450, kStance);
  }
  EXPECT_EQ(estimates.estimate().phase, kStance);
  EXPECT_LT(error(estimates.estimate(), linear_joint(kStanceMass_kg)), kExact);
}

TEST(JointEstimator, MixesThePhasesWhenToldToKeepOneMemory) {
  EstimatorParams params = without_position();
  params.phase_memory = false;
  JointEstimator estimates = estimator(params);
  Joint joint(linear_joint(kStanceMass_kg));
  feed(estimates, joint, 400, kStance);
  const ModelEstimate before = estimates.estimate();
  estimates.take(joint.next(kSwing));
  EXPECT_EQ(estimates.estimate().a, before.a) << "what stance taught is what swing begins with";
  EXPECT_EQ(estimates.estimate().samples, before.samples);
}

TEST(JointEstimator, ForgetsNothingOfAPhaseThatIsNotOn) {
  JointEstimator estimates = estimator(without_position());
  Joint joint(linear_joint(kStanceMass_kg));
  feed(estimates, joint, 1000, kStance);
  const ModelEstimate before = estimates.estimate();
  joint.becomes(linear_joint(kSwingMass_kg));
  feed(estimates, joint, 3000, kSwing);
  estimates.take(joint.next(kStance));
  const ModelEstimate after = estimates.estimate();
  EXPECT_EQ(after.a, before.a);
  EXPECT_EQ(after.b, before.b);
  EXPECT_EQ(after.samples, before.samples);
  EXPECT_EQ(after.excitation, before.excitation);
}

TEST(JointEstimator, TakesNoSampleSoonAfterASwitch) {
  const EstimatorParams params = without_position();
  JointEstimator estimates = estimator(params);
  Joint joint(linear_joint(kSwingMass_kg));
  feed(estimates, joint, 1000, kSwing);
  feed(estimates, joint, 1000, kStance);
  const std::uint32_t known = estimates.estimate().samples;
  feed(estimates, joint, 1000, kSwing);
  for (int tick = 0; tick <= params.blank_ticks; ++tick) {
    estimates.take(joint.next(kStance));
    EXPECT_EQ(estimates.estimate().samples, known) << tick;
    EXPECT_TRUE(has(estimates.estimate(), EstimateFlag::kBlanked)) << tick;
    EXPECT_EQ(estimates.estimate().validity, 0.0) << tick;
  }
  estimates.take(joint.next(kStance));
  EXPECT_EQ(estimates.estimate().samples, known + 1);
  EXPECT_FALSE(has(estimates.estimate(), EstimateFlag::kBlanked));
  EXPECT_GT(estimates.estimate().validity, 0.9) << "what it knew of the phase it still knows";
}

TEST(JointEstimator, IsNotMisledByALoadThatChangesWhileItIsBlind) {
  const EstimatorParams params = without_position();
  JointEstimator estimates = estimator(params);
  Joint joint(linear_joint(kSwingMass_kg));
  for (int stride = 0; stride < 5; ++stride) {
    joint.becomes(linear_joint(kSwingMass_kg));
    feed(estimates, joint, 500, kSwing);
    feed(estimates, joint, params.blank_ticks / 2, kStance);  // announced, but the foot is late
    joint.becomes(linear_joint(kStanceMass_kg));
    feed(estimates, joint, 500, kStance);
    feed(estimates, joint, params.blank_ticks / 2, kSwing);
  }
  estimates.take(joint.next(kStance));
  EXPECT_LT(error(estimates.estimate(), linear_joint(kStanceMass_kg)), kExact);
}

TEST(JointEstimator, IsNotValidBeforeItHasItsSamples) {
  const EstimatorParams params = without_position();
  JointEstimator estimates = estimator(params);
  Joint joint(linear_joint(kStanceMass_kg));
  ModelEstimate estimate = estimates.estimate();
  while (estimate.samples + 1 < static_cast<std::uint32_t>(params.min_samples)) {
    estimates.take(joint.next());
    estimate = estimates.estimate();
    ASSERT_EQ(estimate.validity, 0.0) << estimate.samples;
    ASSERT_TRUE(has(estimate, EstimateFlag::kNotYetSet));
    ASSERT_LT(joint.tick(), kEnough);
  }
  estimates.take(joint.next());
  EXPECT_FALSE(has(estimates.estimate(), EstimateFlag::kNotYetSet));
  EXPECT_GT(estimates.estimate().validity, 0.0);
}

TEST(JointEstimator, IsSurerTheMoreItSeesAndLessSureWhenNothingMoves) {
  const JointScales noisy = scales(kHyqNoise);
  JointEstimator estimates = estimator(without_position(), noisy);
  Joint joint(linear_joint(kStanceMass_kg));
  joint.measured_with(kHyqNoise);
  feed(estimates, joint, 200);
  const ModelEstimate early = estimates.estimate();
  feed(estimates, joint, 1800);
  const ModelEstimate late = estimates.estimate();
  EXPECT_GT(late.validity, early.validity);
  EXPECT_GT(late.excitation, early.excitation);
  joint.dithered_with(0.0);
  feed(estimates, joint, 5000);
  const ModelEstimate idle = estimates.estimate();
  EXPECT_LT(idle.validity, late.validity);
  EXPECT_LT(idle.excitation, late.excitation);
}

TEST(JointEstimator, LeavesOutSamplesThatAreTooSmallWhenToldTo) {
  for (const bool bias : {false, true}) {
    EstimatorParams params = without_position();
    params.bias = bias;
    params.regressor_min = 1e-6;
    JointEstimator estimates = estimator(params);
    Joint joint(linear_joint(kStanceMass_kg));
    feed(estimates, joint, 1000);
    const ModelEstimate before = estimates.estimate();
    EXPECT_FALSE(has(before, EstimateFlag::kRegressorTooSmall));
    for (Tick tick = joint.tick() + 100; tick < joint.tick() + 10'000; ++tick) {
      estimates.take(still(tick));
    }
    EXPECT_TRUE(has(estimates.estimate(), EstimateFlag::kRegressorTooSmall)) << "with bias: " << bias;
    EXPECT_EQ(estimates.estimate().samples, before.samples);
    EXPECT_EQ(estimates.estimate().validity, before.validity) << "nothing was forgotten either";
  }
}

TEST(JointEstimator, LearnsNothingWrongFromAMissingTick) {
  for (const int missing : {1, 2, 3, 50, 1000}) {
    JointEstimator estimates = estimator(without_position());
    Joint joint(linear_joint(kStanceMass_kg));
    feed(estimates, joint, kEnough);
    const double before = error(estimates.estimate(), linear_joint(kStanceMass_kg));
    for (int k = 0; k < missing; ++k) {
      joint.next();
    }
    feed(estimates, joint, 200);
    const ModelEstimate after = estimates.estimate();
    EXPECT_LT(before, kExact);
    EXPECT_LT(error(after, linear_joint(kStanceMass_kg)), kBridged) << missing;
    EXPECT_GT(after.validity, 0.99) << missing;
  }
}

TEST(JointEstimator, RestartsItsFiltersAfterALongGap) {
  JointEstimator estimates = estimator(without_position());
  Joint joint(linear_joint(kStanceMass_kg));
  feed(estimates, joint, kEnough);
  const ModelEstimate before = estimates.estimate();
  for (int k = 0; k < 100; ++k) {
    joint.next();
  }
  const EstimatorParams params;
  constexpr double kTimeConstantsPerStage = 4.0;
  const int settling = static_cast<int>(kTimeConstantsPerStage * params.operating_point_order *
                                        params.operating_point_time_constant_s / kPeriod_s);
  feed(estimates, joint, settling);
  EXPECT_EQ(estimates.estimate().samples, before.samples) << "a mean that has just begun misleads";
  EXPECT_EQ(estimates.estimate().a, before.a);
  EXPECT_EQ(estimates.estimate().validity, before.validity) << "what was known is known";
  feed(estimates, joint, 100);
  EXPECT_GT(estimates.estimate().samples, before.samples);
}

}  // namespace joint_memory_test
}  // namespace farrier::estimation
