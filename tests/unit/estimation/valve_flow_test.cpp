// The estimator of a valve's gain, overlap and leakage, on a piston that a mechanism moves.

#include "estimation/valve/valve_flow_estimator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

#include "control/law/effect_compensation.hpp"
#include "control/law/feedback_linearisation.hpp"
#include "core/noise.hpp"
#include "robot/joint_plant.hpp"
#include "robot/make_estimator.hpp"
#include "robot/wear.hpp"
#include "tests/support/allocation_guard.hpp"

namespace farrier::estimation {
namespace valve_flow_test {

constexpr double kPeriod_s = 1e-3;
constexpr int kSubsteps = 4;
constexpr double kPi = 3.141592653589793;

robot::Joint hfe() {
  const robot::Robot hyq = robot::load_robot(FARRIER_ROBOTS "hyq.yaml", {.on_ground = true}).value();
  return *hyq.find("lf_hfe");
}

/// A worn joint whose piston is moved as a leg in a trot is, under the force law of its file. The estimator reads what its
/// sensors do.
class MovedJoint {
 public:
  explicit MovedJoint(const robot::Wear& wear)
      : plant_(robot::make_plant(robot::worn(joint_, wear), joint_.stance_load).value()),
        law_(joint_.actuator, kGentle, home_, kPeriod_s),
        compensation_(joint_.effects, joint_.actuator, {kPeriod_s, joint_.noise.position, joint_.noise.velocity}),
        estimator_(robot::make_estimator(joint_, kPeriod_s, kDelay).value()) {}

  /// Moves by sines of 1.4 Hz and 3 Hz, in which the piston carries up to 400 N, at 1.4 Hz unless told.
  void run(double time_s, double amplitude_m = 0.007) {
    const Tick end = tick_ + static_cast<Tick>(std::lround(time_s / kPeriod_s));
    for (; tick_ < end; ++tick_) {
      const plant::JointReadings read = plant_.readings();
      const control::Measurement seen{read.position, read.velocity + joint_.noise.velocity * noise_.normal(2 * tick_),
                                      read.load_cell_force + joint_.noise.force * noise_.normal(2 * tick_ + 1)};
      const double t = static_cast<double>(tick_) * kPeriod_s;
      control::Measurement about_home = seen;
      about_home.position -= home_;
      const double reference = 400.0 * std::sin(2.0 * kPi * force_Hz_ * t);
      const double current_A = compensation_.current_A(law_.step(reference, about_home).valve_current_A, about_home);
      estimator_->take({.tick = tick_,
                        .state = {seen.position, seen.velocity, seen.force},
                        .current_A = current_A,
                        .phase = static_cast<int>(tick_ / 350 % 2),
                        .force_error = reference - seen.force,
                        .supply_pressure_Pa = told_supply_Pa_});
      for (int substep = 1; substep <= kSubsteps; ++substep) {
        const double then = t + kPeriod_s * substep / kSubsteps;
        const double a = 2.0 * kPi * 1.4, b = 2.0 * kPi * 3.0;
        plant_.follow(last_A_, std::nullopt,
                      {home_ + amplitude_m * (std::sin(a * then) + 0.4 * std::sin(b * then)),
                       amplitude_m * (a * std::cos(a * then) + 0.4 * b * std::cos(b * then))},
                      kPeriod_s / kSubsteps);
      }
      last_A_ = current_A;
    }
  }
  void wear(const robot::Wear& wear) {
    const robot::Joint worn = robot::worn(joint_, wear);
    ASSERT_TRUE(plant_.set_actuator(worn.actuator, worn.effects));
  }
  void weaken_supply(double pressure_Pa, bool told) {
    plant::ActuatorParams weak = joint_.actuator;
    weak.supply_pressure_Pa = pressure_Pa;
    ASSERT_TRUE(plant_.set_actuator(weak, joint_.effects));
    told_supply_Pa_ = told ? pressure_Pa : 0.0;
  }
  void press_with(double frequency_Hz) { force_Hz_ = frequency_Hz; }
  ModelEstimate estimate() const { return estimator_->estimate(); }
  double gain() const { return estimate().physics.valve_gain / joint_.actuator.valve_gain; }
  double overlap_percent() const { return 100.0 * estimate().physics.overlap_A / joint_.actuator.valve_current_max_A; }
  Estimator& estimator() { return *estimator_; }
  Tick tick() const { return tick_; }
  const robot::Joint& joint() const { return joint_; }

 private:
  static constexpr int kDelay = 1;
  // A mechanism that does not yield is a stiffer load than a robot.
  static constexpr control::FeedbackLinearisationGains kGentle{
      .force_1_s = 400.0, .integral_1_s2 = 0.0, .velocity_compensation = 0.9};

  robot::Joint joint_ = hfe();
  double home_ = joint_.linkage.position(joint_.home_angle_rad);
  plant::Joint plant_;
  control::FeedbackLinearisation law_;
  control::EffectCompensation compensation_;
  std::unique_ptr<Estimator> estimator_;
  NoiseStream noise_{1, "moved joint", "sensors"};
  double last_A_ = 0.0;
  double told_supply_Pa_ = 0.0;
  double force_Hz_ = 1.4;
  Tick tick_ = 0;
};

robot::Wear no_wear() { return robot::no_wear(hfe()); }

TEST(ValveFlow, FindsTheGainOfAWornValveWithinThreePercent) {
  for (const double gain : {0.7, 1.0, 1.3}) {
    robot::Wear wear = no_wear();
    wear.valve_gain = gain;
    MovedJoint moved(wear);
    moved.run(3.0);
    const ModelEstimate estimate = moved.estimate();
    EXPECT_NEAR(moved.gain(), gain, 0.03 * gain) << gain;
    EXPECT_NEAR(moved.overlap_percent(), 0.6, 0.3) << gain;
    EXPECT_GT(estimate.validity, 0.9);
    EXPECT_TRUE(estimate.has_physics);
  }
}

TEST(ValveFlow, FindsAWiderOverlap) {
  robot::Wear wear = no_wear();
  wear.overlap_A = 3e-4;
  MovedJoint moved(wear);
  moved.run(4.0);
  EXPECT_NEAR(moved.overlap_percent(), 3.0, 0.4);
  EXPECT_NEAR(moved.gain(), 1.0, 0.06);
}

TEST(ValveFlow, FindsALeakagePastThePiston) {
  robot::Wear wear = no_wear();
  wear.leakage = 5e-13;
  MovedJoint moved(wear);
  moved.run(4.0);
  EXPECT_NEAR(moved.estimate().physics.leakage, 5e-13, 1.5e-13);
}

TEST(ValveFlow, FindsOilThatIsSofterThanItsFileSays) {
  for (const double bulk_modulus : {0.4, 1.0}) {
    robot::Wear wear = no_wear();
    wear.bulk_modulus = bulk_modulus;
    MovedJoint moved(wear);
    moved.press_with(8.0);
    moved.run(10.0);
    const ModelEstimate estimate = moved.estimate();
    const double nominal_Pa = moved.joint().actuator.bulk_modulus_Pa;
    EXPECT_NEAR(nominal_Pa / estimate.physics.bulk_modulus, 1.0 / bulk_modulus, 0.3 / bulk_modulus) << bulk_modulus;
    EXPECT_GT(estimate.physics_error.bulk_modulus, 0.0);
    EXPECT_NEAR(moved.gain(), 1.0, 0.04) << bulk_modulus;
  }
}

TEST(ValveFlow, FollowsAValveThatLosesHalfItsGainWithinAFifthOfASecond) {
  MovedJoint moved(no_wear());
  moved.run(3.0);
  EXPECT_NEAR(moved.gain(), 1.0, 0.03);
  robot::Wear lost = no_wear();
  lost.valve_gain = 0.5;
  moved.wear(lost);
  moved.run(0.2);
  EXPECT_NEAR(moved.gain(), 0.5, 0.05);
}

TEST(ValveFlow, CountsAValveThatGrowsAsStrongerUntilItIsEstimatedAgain) {
  MovedJoint moved(no_wear());
  moved.run(3.0);
  robot::Wear grown = no_wear();
  grown.valve_gain = 1.75;
  moved.wear(grown);
  moved.run(0.03);
  const ModelEstimate counted = moved.estimate();
  EXPECT_NE(counted.flags & bit(EstimateFlag::kCountsAsStronger), 0u);
  EXPECT_EQ(counted.validity, 0.0);
  EXPECT_GT(moved.gain(), 1.4);
  moved.run(1.0);
  EXPECT_EQ(moved.estimate().flags & bit(EstimateFlag::kCountsAsStronger), 0u);
  EXPECT_NEAR(moved.gain(), 1.75, 0.09);
}

TEST(ValveFlow, StaysAsSureOfTheOilWhenTheValveChanges) {
  MovedJoint moved(no_wear());
  moved.run(3.0);
  const ModelEstimate before = moved.estimate();
  robot::Wear grown = no_wear();
  grown.valve_gain = 1.75;
  moved.wear(grown);
  moved.run(0.03);
  const ModelEstimate after = moved.estimate();
  ASSERT_NE(after.flags & bit(EstimateFlag::kCountsAsStronger), 0u);
  EXPECT_GT(after.physics_error.valve_gain, 3.0 * before.physics_error.valve_gain);
  EXPECT_LT(after.physics_error.bulk_modulus, 2.1 * before.physics_error.bulk_modulus);
}

void oscillate(MovedJoint& moved) {
  for (Tick tick = 0; tick < 50; ++tick) {
    const double error_N = 900.0 * std::sin(2.0 * kPi * 0.115 * static_cast<double>(tick));
    moved.estimator().take({.tick = moved.tick() + tick,
                            .state = {0.04, 0.0, -error_N},
                            .current_A = 1e-5,
                            .phase = 0,
                            .force_error = error_N});
  }
}

TEST(ValveFlow, CountsTheValveOfAnOscillatingLoopAsStronger) {
  MovedJoint moved(no_wear());
  moved.run(2.0);
  oscillate(moved);
  EXPECT_NE(moved.estimate().flags & bit(EstimateFlag::kCountsAsStronger), 0u);
  EXPECT_NEAR(moved.gain(), 1.5, 0.05);
}

TEST(ValveFlow, CountsTheOilAsStifferIfTheLoopOscillatesAgainWithTheSameValve) {
  MovedJoint moved(no_wear());
  const double nominal_Pa = moved.joint().actuator.bulk_modulus_Pa;
  moved.run(2.0);
  oscillate(moved);
  EXPECT_EQ(moved.estimate().physics.bulk_modulus, nominal_Pa) << "the valve is suspected first";
  moved.run(1.0);
  EXPECT_NEAR(moved.gain(), 1.0, 0.1);
  oscillate(moved);
  EXPECT_DOUBLE_EQ(moved.estimate().physics.bulk_modulus, 1.5 * nominal_Pa);
  moved.run(1.0);
  for (int again = 0; again < 5; ++again) {
    oscillate(moved);
    moved.run(1.0);
  }
  EXPECT_DOUBLE_EQ(moved.estimate().physics.bulk_modulus, 2.0 * nominal_Pa) << "the largest that is given on";
}

TEST(ValveFlow, DoesNotTakeAWeakSupplyForAWeakValveOnceItIsTold) {
  for (const bool told : {true, false}) {
    MovedJoint moved(no_wear());
    moved.weaken_supply(112e5, told);
    moved.run(3.0);
    if (told) {
      EXPECT_NEAR(moved.gain(), 1.0, 0.04);
    } else {
      EXPECT_LT(moved.gain(), 0.9);
    }
  }
}

TEST(ValveFlow, FindsTheGainInThickOil) {
  robot::Wear wear = no_wear();
  wear.viscosity = 4.0;
  MovedJoint moved(wear);
  moved.run(4.0);
  EXPECT_NEAR(moved.gain(), 1.0, 0.05);
}

TEST(ValveFlow, LearnsNothingFromAShutValve) {
  MovedJoint moved(no_wear());
  for (Tick tick = 0; tick < 500; ++tick) {
    moved.estimator().take({.tick = tick, .state = {0.04, 0.0, 300.0}, .current_A = 2e-5, .phase = 0});
  }
  const ModelEstimate estimate = moved.estimate();
  EXPECT_EQ(estimate.samples, 0u);
  EXPECT_EQ(estimate.validity, 0.0);
  EXPECT_NE(estimate.flags & bit(EstimateFlag::kNotYetSet), 0u);
  EXPECT_NE(estimate.flags & bit(EstimateFlag::kNotExciting), 0u);
  EXPECT_EQ(moved.gain(), 1.0) << "the file's until something is learnt";
}

TEST(ValveFlow, KeepsTheLoadOfTheFile) {
  robot::Wear wear = no_wear();
  wear.valve_gain = 0.7;
  MovedJoint moved(wear);
  moved.run(2.0);
  const ModelEstimate estimate = moved.estimate();
  const bool swings = estimate.phase == static_cast<int>(Phase::kSwing);
  EXPECT_EQ(estimate.physics.load_mass, (swings ? moved.joint().swing_load : moved.joint().stance_load).mass);
  EXPECT_EQ(estimate.physics_error.load_mass, 0.0);
}

TEST(ValveFlow, StaysFiniteThroughGapsAndSamplesThatAreNot) {
  MovedJoint moved(no_wear());
  moved.run(1.0);
  const double before = moved.gain();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  moved.estimator().take({.tick = moved.tick(), .state = {nan, 0.0, 0.0}, .current_A = 0.0, .phase = 0});
  EXPECT_NE(moved.estimate().flags & bit(EstimateFlag::kSampleRefused), 0u);
  moved.estimator().take({.tick = moved.tick() + 500, .state = {0.04, 5.0, -3000.0}, .current_A = 0.01, .phase = 1});
  EXPECT_EQ(moved.gain(), before);
}

TEST(ValveFlow, AllocatesNothing) {
  MovedJoint moved(no_wear());
  moved.run(0.5);
  const test::AllocationGuard guard;
  moved.estimator().take({.tick = moved.tick(), .state = {0.04, 0.1, 100.0}, .current_A = 0.001, .phase = 0});
  const ModelEstimate estimate = moved.estimate();
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_TRUE(estimate.a.allFinite());
}

TEST(ValveFlow, RefusesSettingsOutOfRange) {
  robot::Joint joint = hfe();
  joint.estimator.valve_flow = ValveFlowParams{.memory_s = 0.0};
  const auto refused = robot::make_estimator(joint, kPeriod_s, 1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "lf_hfe: valve_flow: memory_s must be above 0, is 0.000000");
}

}  // namespace valve_flow_test
}  // namespace farrier::estimation
