#include "locomotion/supply_guard.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace farrier::locomotion {
namespace supply_guard_test {

constexpr double kPeriod_s = 1e-3;
constexpr double kPump_m3_s = 2e-4;
constexpr MotionCommand kTrot{.request = Request::kTrot, .forward_m_s = 0.4, .height_m = 0.6};

SupplyGuard guard() {
  return SupplyGuard({.low_Pa = 128e5, .recovered_Pa = 144e5, .lie_Pa = 96e5, .least_pump_flow_m3_s = 1e-5}, kPeriod_s);
}

/// The command that acts after this reading has lasted.
MotionCommand after(SupplyGuard& guard, double seconds, double pressure_Pa, double flow_m3_s = kPump_m3_s,
                    const MotionCommand& asked = kTrot) {
  MotionCommand command;
  for (int tick = 0; tick < std::lround(seconds / kPeriod_s); ++tick) {
    command = guard.step(asked, SupplyReading{pressure_Pa, flow_m3_s});
  }
  return command;
}

TEST(LowAlarm, StaysOnUntilTheHigherLimit) {
  LowAlarm alarm(1.0, 2.0);
  EXPECT_FALSE(alarm.step(1.0));
  EXPECT_TRUE(alarm.step(0.9));
  EXPECT_TRUE(alarm.step(1.9));
  EXPECT_FALSE(alarm.step(2.0));
  EXPECT_FALSE(alarm.step(1.5));
  EXPECT_TRUE(alarm.step(std::numeric_limits<double>::quiet_NaN()));
}

TEST(SupplyGuard, DemandsNothingBeforeTheFirstReading) {
  SupplyGuard guard = supply_guard_test::guard();
  for (int tick = 0; tick < 1000; ++tick) {
    ASSERT_EQ(guard.step(kTrot, std::nullopt).request, Request::kTrot);
  }
}

TEST(SupplyGuard, PassesTheCommandOfAGoodSupply) {
  SupplyGuard guard = supply_guard_test::guard();
  const MotionCommand command = after(guard, 10.0, 130e5);
  EXPECT_EQ(command.request, Request::kTrot);
  EXPECT_EQ(command.forward_m_s, 0.4);
  EXPECT_FALSE(command.at_once);
}

SupplyGuard slowing_guard() {
  return SupplyGuard({.low_Pa = 128e5, .slow_Pa = 136e5, .recovered_Pa = 144e5, .lie_Pa = 96e5}, kPeriod_s);
}

TEST(SupplyGuard, SlowsDownBetweenLowAndSlow) {
  SupplyGuard guard = slowing_guard();
  EXPECT_EQ(after(guard, 1.0, 137e5).forward_m_s, 0.4);
  EXPECT_EQ(guard.demand(), SupplyDemand::kNone);
  const MotionCommand slower =
      after(guard, 1.0, 130e5, kPump_m3_s,
            {.request = Request::kTrot, .forward_m_s = 0.4, .left_m_s = -0.2, .yaw_rate_rad_s = 0.6});
  EXPECT_EQ(slower.request, Request::kTrot);
  EXPECT_NEAR(slower.forward_m_s, 0.5 * 0.4, 1e-9);
  EXPECT_NEAR(slower.left_m_s, -0.5 * 0.2, 1e-9);
  EXPECT_NEAR(slower.yaw_rate_rad_s, 0.5 * 0.6, 1e-9);
  EXPECT_EQ(guard.demand(), SupplyDemand::kSlow);
  EXPECT_TRUE(slower.weak_supply);
  EXPECT_NEAR(after(guard, 10.0, 130e5).forward_m_s, 0.3 * 0.4, 1e-9) << "the slowest";
}

TEST(SupplyGuard, SpeedsUpFromTheHigherLimitOn) {
  SupplyGuard guard = slowing_guard();
  after(guard, 1.0, 130e5);
  EXPECT_NEAR(after(guard, 10.0, 143e5).forward_m_s, 0.2, 1e-9) << "between the limits the speed stays";
  EXPECT_NEAR(after(guard, 2.0, 145e5).forward_m_s, (0.5 + 0.2) * 0.4, 1e-9);
  EXPECT_EQ(guard.demand(), SupplyDemand::kSlow);
  EXPECT_EQ(after(guard, 4.0, 145e5).forward_m_s, 0.4);
  EXPECT_EQ(guard.demand(), SupplyDemand::kNone) << "no operator is needed";
}

TEST(SupplyGuard, ChangesTheSpeedWithoutAStep) {
  SupplyGuard guard = slowing_guard();
  double before = 1.0;
  for (const double pressure_Pa : {130e5, 150e5, std::numeric_limits<double>::quiet_NaN(), 150e5}) {
    for (int tick = 0; tick < 1000; ++tick) {
      guard.step(kTrot, SupplyReading{pressure_Pa, kPump_m3_s});
      ASSERT_LE(std::abs(guard.speed() - before), 0.5 * kPeriod_s + 1e-12);
      before = guard.speed();
    }
  }
}

TEST(SupplyGuard, StandsWhenSlowingDoesNotSuffice) {
  SupplyGuard guard = slowing_guard();
  after(guard, 2.0, 130e5);
  EXPECT_EQ(after(guard, 0.31, 120e5).request, Request::kStand);
  EXPECT_EQ(guard.demand(), SupplyDemand::kStand);
}

TEST(SupplyGuard, StandsWhenTheSupplyIsLowForLong) {
  SupplyGuard guard = supply_guard_test::guard();
  EXPECT_EQ(after(guard, 0.29, 120e5).request, Request::kTrot);
  EXPECT_EQ(after(guard, 0.02, 120e5).request, Request::kStand);
  EXPECT_EQ(guard.demand(), SupplyDemand::kStand);
  EXPECT_EQ(after(guard, 0.1, 120e5, kPump_m3_s, {.request = Request::kLie}).request, Request::kLie);
}

TEST(SupplyGuard, DoesNotStandForASagThatIsShort) {
  SupplyGuard guard = supply_guard_test::guard();
  for (int stride = 0; stride < 10; ++stride) {
    EXPECT_EQ(after(guard, 0.2, 120e5).request, Request::kTrot);
    EXPECT_EQ(after(guard, 0.2, 150e5).request, Request::kTrot);
  }
}

TEST(SupplyGuard, LiesDownAtOnceWithoutPressureOrPump) {
  SupplyGuard without_pressure = guard();
  EXPECT_EQ(after(without_pressure, 0.09, 90e5).request, Request::kTrot);
  EXPECT_EQ(after(without_pressure, 0.02, 90e5).request, Request::kLie);
  SupplyGuard without_pump = guard();
  const MotionCommand command = after(without_pump, 0.11, 150e5, 0.0);
  EXPECT_EQ(command.request, Request::kLie);
  EXPECT_TRUE(command.at_once);
  EXPECT_EQ(without_pump.demand(), SupplyDemand::kLie);
}

TEST(SupplyGuard, TakesANumberThatIsNotFiniteAsNoPressure) {
  SupplyGuard guard = supply_guard_test::guard();
  EXPECT_EQ(after(guard, 0.11, std::numeric_limits<double>::quiet_NaN()).request, Request::kLie);
}

TEST(SupplyGuard, GoesOnOnlyAfterTheOperatorAskedForLess) {
  SupplyGuard guard = supply_guard_test::guard();
  after(guard, 0.4, 120e5);
  EXPECT_EQ(after(guard, 5.0, 160e5).request, Request::kStand) << "it recovered, but nobody asked to stand";
  after(guard, 0.1, 160e5, kPump_m3_s, {.request = Request::kStand});
  EXPECT_EQ(after(guard, 0.1, 160e5).request, Request::kTrot);
}

TEST(SupplyGuard, KeepsARobotDownUntilThePumpRuns) {
  SupplyGuard guard = supply_guard_test::guard();
  after(guard, 0.2, 150e5, 0.0);
  after(guard, 0.1, 150e5, 0.0, {.request = Request::kLie});
  EXPECT_EQ(after(guard, 0.1, 150e5, 0.0).request, Request::kLie) << "the pump still stands";
  after(guard, 0.1, 160e5, kPump_m3_s, {.request = Request::kStand});
  EXPECT_EQ(guard.demand(), SupplyDemand::kLie) << "to stand is more than to lie";
  after(guard, 0.1, 160e5, kPump_m3_s, {.request = Request::kLie});
  EXPECT_EQ(after(guard, 0.1, 160e5).request, Request::kTrot);
}

}  // namespace supply_guard_test
}  // namespace farrier::locomotion
