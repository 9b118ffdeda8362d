// Faults of the supply and of a valve under a walking robot.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "trials/body/trot_trial.hpp"

namespace farrier::trials {
namespace trot_faults_test {

robot::Robot load_on_ground(const std::string& name) {
  return robot::load_robot(FARRIER_ROBOTS + name + ".yaml", {.on_ground = true}).value();
}

/// The first case of a trial on hydraulic joints, until `seconds` after the fault of its supply.
TrotFigures after_fault(const std::string& trial, double seconds) {
  const robot::Robot hyq = load_on_ground("hyq");
  const std::vector<TrotCase> cases = trot_cases(hyq);
  TrotCase one = *std::ranges::find(cases, trial, &TrotCase::trial);
  one.end_s = *one.fault_s + seconds;
  return run_trot_case(hyq, one, Joints::kActuators).value().value();
}

TEST(TrotTrial, WalksOnWithAWeakPumpAndASmallAccumulator) {
  const TrotFigures figures = after_fault("supply", 5.0);
  EXPECT_FALSE(figures.fell_s.has_value());
  EXPECT_LT(figures.least_supply_Pa, 144e5);
  ASSERT_TRUE(figures.supply);
  EXPECT_FALSE(figures.supply->low_s.has_value());
  EXPECT_FALSE(figures.supply->acts_s.has_value());
  EXPECT_LT(figures.energy_error, 0.01);
}

TEST(TrotTrial, FindsTheWorkOfThePumpAgain) {
  const robot::Robot hyq = load_on_ground("hyq");
  const std::vector<TrotCase> cases = trot_cases(hyq);
  TrotCase one = *std::ranges::find(cases, "energy", &TrotCase::trial);
  one.judged_from_s = one.trot_s;
  one.judged_until_s = one.end_s = one.trot_s + 2.0;
  const world::EnergyAudit energy = run_trot_case(hyq, one, Joints::kActuators).value()->energy;
  EXPECT_NEAR(energy.pump_J, 2.0 * 160e5 * hyq.supply->pump_flow_m3_s, 0.02 * energy.pump_J);
  EXPECT_LT(std::abs(energy.residual_J()), 0.01 * energy.pump_J);
  for (const double term_J : {energy.relief_J, energy.supply_leakage_J, energy.valve_J, energy.friction_J}) {
    EXPECT_GT(term_J, 0.01 * energy.pump_J);
  }
}

// The accumulator has oil for 1.7 s of trot.
TEST(TrotTrial, LiesDownOnTheOilOfItsAccumulatorWhenThePumpStops) {
  const TrotFigures figures = after_fault("pump_stops", 3.0);
  EXPECT_FALSE(figures.fell_s.has_value());
  ASSERT_TRUE(figures.supply);
  EXPECT_LT(figures.supply->acts_s.value(), 0.15);
  EXPECT_LT(figures.supply->lying_s.value(), 1.6);
  EXPECT_LT(figures.supply->largest_sinking_m_s, 0.5);
}

TEST(TrotTrial, LiesDownSoftlyWithAValveThatSticks) {
  const TrotFigures figures = after_fault("dead_joint", 3.0);
  EXPECT_FALSE(figures.fell_s.has_value());
  ASSERT_TRUE(figures.supply);
  EXPECT_LT(figures.supply->acts_s.value(), 0.5);
  EXPECT_TRUE(figures.supply->lying_s.has_value());
  EXPECT_LT(figures.supply->largest_sinking_m_s, 0.5);
}

TEST(TrotTrial, WalksOnMoreSlowlyWithHalfThePump) {
  const TrotFigures figures = after_fault("low_supply", 14.0);
  EXPECT_FALSE(figures.fell_s.has_value());
  ASSERT_TRUE(figures.supply);
  EXPECT_TRUE(figures.supply->slows_s.has_value());
  EXPECT_FALSE(figures.supply->acts_s.has_value());
  EXPECT_TRUE(figures.supply->recovers);
  EXPECT_LT(figures.supply->end_speed_m_s, 0.3);
  EXPECT_GT(figures.supply->end_speed_m_s, 0.1);
}

}  // namespace trot_faults_test
}  // namespace farrier::trials
