// The hysteresis of a valve against a spool that is moved by hand.

#include <gtest/gtest.h>

#include <cmath>

#include "test_effects.hpp"

namespace farrier::plant {
namespace valve_hysteresis_test {

using test::effect_of;
using test::joint_with;
using test::kPeriod_s;
using test::same;

const ActuatorParams kCylinder = test::hyq_cylinder();
const LoadParams kLoad = test::swing_load();
/// Its product with and quotient by the scale are exact.
const double kWidth_A = kCylinder.valve_current_max_A * 0.0625;

ActiveEffect hysteresis() { return effect_of("valve_hysteresis", {kWidth_A}, kCylinder, kLoad); }

double current_A(int tick) { return tick < 0 ? 0.0 : 0.003 * std::sin(0.2 * tick + 1.0); }

/// The current of a spool that follows only where the current has moved on by the half width.
class Follower {
 public:
  explicit Follower(double half_width_A) : half_width_A_(half_width_A) {}
  double operator()(double current_A) {
    if (std::abs(current_A - spool_A_) > half_width_A_) {
      spool_A_ = current_A - std::copysign(half_width_A_, current_A - spool_A_);
    }
    return spool_A_;
  }

 private:
  double half_width_A_, spool_A_ = 0.0;
};

TEST(ValveHysteresis, LetsTheSpoolFollowOnlyAfterItsHalfWidth) {
  HydraulicJoint with = joint_with(kCylinder, kLoad, {hysteresis()});
  HydraulicJoint nominal = joint_with(kCylinder, kLoad, {});
  Follower follower(kWidth_A);
  for (int tick = 0; tick < 300; ++tick) {
    with.step(current_A(tick), 0.0, kPeriod_s);
    nominal.step(follower(current_A(tick)), 0.0, kPeriod_s);
    ASSERT_TRUE(same(with, nominal)) << tick;
  }
}

TEST(ValveHysteresis, ActsOnTheDelayedCurrentAndBeforeTheNullShift) {
  HydraulicJoint with = joint_with(kCylinder, kLoad,
                                   {hysteresis(), effect_of("input_delay", {2e-3}, kCylinder, kLoad),
                                    effect_of("valve_bias", {kWidth_A}, kCylinder, kLoad)});
  HydraulicJoint nominal = joint_with(kCylinder, kLoad, {});
  Follower follower(kWidth_A);
  for (int tick = 0; tick < 300; ++tick) {
    with.step(current_A(tick), 0.0, kPeriod_s);
    nominal.step(follower(current_A(tick - 2)) + kWidth_A, 0.0, kPeriod_s);
    ASSERT_TRUE(same(with, nominal)) << tick;
  }
}

TEST(ValveHysteresis, KeepsItsSpoolWhereItIsWhenTheValveIsSetAgain) {
  const std::vector<ActiveEffect> effects{hysteresis()};
  HydraulicJoint once = joint_with(kCylinder, kLoad, effects);
  HydraulicJoint again = joint_with(kCylinder, kLoad, effects);
  for (int tick = 0; tick < 100; ++tick) {
    ASSERT_TRUE(again.set_actuator(kCylinder, effects));
    once.step(current_A(tick), 0.0, kPeriod_s);
    again.step(current_A(tick), 0.0, kPeriod_s);
    ASSERT_TRUE(same(once, again)) << tick;
  }
}

TEST(ValveHysteresis, IsPassedOnWhereAMechanismMovesThePiston) {
  HydraulicJoint with = joint_with(kCylinder, kLoad, {hysteresis()});
  HydraulicJoint nominal = joint_with(kCylinder, kLoad, {});
  Follower follower(kWidth_A);
  OilAccount account;
  const Motion end{with.state().position, 0.0};
  for (int tick = 0; tick < 100; ++tick) {
    with.follow(current_A(tick), kCylinder.supply_pressure_Pa, end, kPeriod_s, account);
    nominal.follow(follower(current_A(tick)), kCylinder.supply_pressure_Pa, end, kPeriod_s, account);
    ASSERT_TRUE(same(with, nominal)) << tick;
  }
}

TEST(ValveHysteresis, IsNotMovedByAPeriodThatIsRefused) {
  HydraulicJoint with = joint_with(kCylinder, kLoad, {hysteresis()});
  HydraulicJoint other = joint_with(kCylinder, kLoad, {hysteresis()});
  with.step(4.0 * kWidth_A, 0.0, -1.0);
  with.step(0.5 * kWidth_A, 0.0, kPeriod_s);
  other.step(0.5 * kWidth_A, 0.0, kPeriod_s);
  EXPECT_TRUE(same(with, other));
}

}  // namespace valve_hysteresis_test
}  // namespace farrier::plant
