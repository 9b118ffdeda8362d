// Compensation of effects: each inverse against the plant's own term, which it knows nothing of but its numbers.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "control/law/effect_compensation.hpp"
#include "tests/support/allocation_guard.hpp"
#include "tests/unit/control/effects.hpp"

namespace farrier::control {
namespace effect_compensation_test {

constexpr CompensationParams kParams{kPeriod_s, 2e-6, 1.5e-3};
constexpr Measurement kAtRest{0.0, 0.0, 0.0};

const ActiveEffect kOverlap{effect_id<plant::ValveDeadband>(), {4e-4}};
const ActiveEffect kPorts{effect_id<plant::ValveAsymmetry>(), {-0.3}};
const ActiveEffect kPort{effect_id<plant::FlowSaturation>(), {0.006}};
const ActiveEffect kBias{effect_id<plant::ValveBias>(), {-3e-4}};
const ActiveEffect kDelay{effect_id<plant::InputDelay>(), {0.0035}};
const ActiveEffect kCellGain{effect_id<plant::ForceSensorGain>(), {1.2}};
const ActiveEffect kCellOffset{effect_id<plant::ForceSensorOffset>(), {-35.0}};
const ActiveEffect kVelocityLag{effect_id<plant::VelocityFilterLag>(), {0.006}};

TEST(EffectCompensation, WithoutEffectsGivesBackWhatItGetsBitForBit) {
  const std::vector<ActiveEffect> others{{effect_id<plant::LoadFriction>(), {20.0, 1.3, 0.01}},
                                         {effect_id<plant::LoadMass>(), {3.0}}};
  for (const auto& effects : {std::vector<ActiveEffect>{}, others}) {
    EffectCompensation compensation(effects, kActuator, kParams);
    std::mt19937_64 random(1);
    std::normal_distribution<double> draw;
    for (int i = 0; i < 100; ++i) {
      const Measurement read{draw(random), draw(random), 100.0 * draw(random)};
      const Measurement same = compensation.corrected(read);
      EXPECT_EQ(same.position, read.position);
      EXPECT_EQ(same.velocity, read.velocity);
      EXPECT_EQ(same.force, read.force);
      const double current_A = draw(random);  // beyond the limit too
      EXPECT_EQ(compensation.current_A(current_A, kAtRest), current_A);
    }
    EXPECT_EQ(compensation.delay_s(), 0.0);
  }
}

TEST(EffectCompensation, OpensThePlantsPortsAsAnIdealValveWould) {
  const std::vector<ActiveEffect> effects{kOverlap, kPorts, kPort, kBias};
  EffectCompensation compensation(effects, kActuator, kParams);
  plant::TermSet<double> terms = terms_of(effects);
  for (double asked_A = -2.5e-3; asked_A <= 2.5e-3; asked_A += 1e-5) {
    const double opened_A = opening_A(terms, compensation.current_A(asked_A, kAtRest));
    const double crossing_A = 1.3 * ValveInverse::kCrossing * kOverlap.values[0];
    ASSERT_NEAR(opened_A, asked_A, std::abs(asked_A) < crossing_A ? 1.3 * crossing_A : 1e-15) << asked_A;
  }
}

TEST(EffectCompensation, CrossesTheOverlapWithoutAJumpAndLeavesLessThanATenthOfItDead) {
  const ValveInverse inverse(std::vector{kOverlap}, kMost_A);
  plant::TermSet<double> terms = terms_of({kOverlap});
  const double overlap_A = kOverlap.values[0];
  constexpr double kStep_A = 1e-8;
  // Slope of the cubic in its middle.
  const double steepest = 1.0 + 1.5 / ValveInverse::kCrossing;
  double before_A = inverse.current_A(-1e-4);
  for (double asked_A = -1e-4 + kStep_A; asked_A < 1e-4; asked_A += kStep_A) {
    const double now_A = inverse.current_A(asked_A);
    ASSERT_GT(now_A, before_A);
    ASSERT_LT(now_A - before_A, 1.001 * steepest * kStep_A);
    before_A = now_A;
  }
  EXPECT_EQ(inverse.current_A(0.0), 0.0);
  EXPECT_DOUBLE_EQ(inverse.current_A(-3e-5), -inverse.current_A(3e-5));
  EXPECT_GT(opening_A(terms, inverse.current_A(ValveInverse::kCrossing * overlap_A)), 0.0);
}

TEST(EffectCompensation, StaysWithinTheValvesLimitWhateverIsAsked) {
  EffectCompensation compensation(std::vector{kOverlap, kPorts, kPort, kBias, kSpool}, kActuator, kParams);
  for (const double asked_A : {1e9, -1e9, 0.02, -0.02, 0.0, 0.006, -0.0045}) {
    for (int i = 0; i < 20; ++i) {
      ASSERT_TRUE(std::abs(compensation.current_A(asked_A, kAtRest)) <= kMost_A) << asked_A;
    }
  }
}

TEST(EffectCompensation, ReadsTheForceAsASensorWithoutGainOffsetAndLagWould) {
  const std::vector<ActiveEffect> steady{kCellGain, kCellOffset};
  EffectCompensation compensation(steady, kActuator, kParams);
  plant::TermSet<double> cell = terms_of({kCellGain, kCellOffset});
  for (const double force : {-500.0, 0.0, 1.0, 320.0}) {
    plant::ForceMoment<double> now{force};
    cell.on_force(now);
    EXPECT_NEAR(compensation.corrected({0.0, 0.0, now.force}).force, force, 1e-12);
  }
}

TEST(EffectCompensation, TakesTheVelocityFromThePositionWhereItsSensorLags) {
  EffectCompensation compensation(std::vector{kVelocityLag}, kActuator, kParams);
  constexpr double kSpeed_m_s = 0.2;
  double velocity = 0.0;
  for (int k = 0; k < 50; ++k) {
    velocity = compensation.corrected({kSpeed_m_s * k * kPeriod_s, -7.0, 0.0}).velocity;
  }
  EXPECT_NEAR(velocity, kSpeed_m_s, 1e-6);
  // No noisier than the sensor whose place it takes.
  std::mt19937_64 random(5);
  std::normal_distribution<double> draw(0.0, kParams.position_noise);
  double squares = 0.0;
  constexpr int kSamples = 20'000;
  compensation.reset();
  for (int k = 0; k < kSamples; ++k) {
    const double out = compensation.corrected({draw(random), 0.0, 0.0}).velocity;
    squares += out * out;
  }
  EXPECT_LE(std::sqrt(squares / kSamples), kParams.velocity_noise);
  // A lag shorter than the smoothing is left alone.
  ActiveEffect quick = kVelocityLag;
  quick.values[0] = 0.001;
  EffectCompensation left(std::vector{quick}, kActuator, kParams);
  EXPECT_EQ(left.corrected({0.1, -7.0, 0.0}).velocity, -7.0);
}

TEST(EffectCompensation, NeitherAllocatesNorKeepsWhatIsNotFinite) {
  const std::vector<ActiveEffect> all{kOverlap, kPorts,    kPort,       kBias,        kSpool,
                                      kDelay,   kCellLag, kCellGain, kCellOffset, kVelocityLag};
  EffectCompensation compensation(all, kActuator, kParams);
  EffectCompensation fresh = compensation;
  const test::AllocationGuard guard;
  for (const double wild : {1e308, -1e308, 1e300}) {
    compensation.corrected({wild, wild, wild});
  }
  compensation.reset();
  for (int k = 0; k < 20; ++k) {
    const Measurement read{0.01 * k, 0.1, 5.0 * k};
    EXPECT_EQ(compensation.corrected(read).force, fresh.corrected(read).force);
    EXPECT_EQ(compensation.current_A(1e-4 * k, kAtRest), fresh.current_A(1e-4 * k, kAtRest));
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

TEST(EffectCompensation, DelaysByTheInputsAndWhatIsLeftOfTheSpools) {
  EXPECT_EQ(EffectCompensation(std::vector{kDelay}, kActuator, kParams).delay_s(), 0.0035);
  const SpoolLead spool(kSpool.values[0], kSpool.values[1], kMost_A, kPeriod_s);
  EXPECT_DOUBLE_EQ(EffectCompensation(std::vector{kDelay, kSpool}, kActuator, kParams).delay_s(),
                   0.0035 + spool.lag_ticks() * kPeriod_s);
}

// Each effect of the list does something, and none beside it: all sensors', all that change a flow, and the delay.
TEST(EffectCompensation, ListsWhatActsOnItAndNoOther) {
  const plant::Scales scales(kActuator, plant::nominal_load());
  for (plant::EffectId id = 0; id < plant::kEffectCount; ++id) {
    const plant::EffectInfo& info = plant::effect_info(id);
    ActiveEffect effect{id, {}};
    for (std::size_t i = 0; i < info.parameters.size(); ++i) {
      effect.values[i] = scales.value(info.parameters[i], info.parameters[i].starts[1]);
    }
    EffectCompensation compensation(std::vector{effect}, kActuator, kParams);
    bool acts = compensation.delay_s() > 0.0;
    for (int k = 0; k < 5; ++k) {
      const Measurement read{0.01 * k, 0.1 * k, 7.0 * k};
      const Measurement truth = compensation.corrected(read);
      acts = acts || truth.force != read.force || truth.velocity != read.velocity ||
             compensation.current_A(2e-3, kAtRest) != 2e-3;
    }
    EXPECT_EQ(acts, is_compensated(id)) << info.name;
  }
}

}  // namespace effect_compensation_test
}  // namespace farrier::control
