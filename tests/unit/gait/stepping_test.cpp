// The order in which legs step, and the share of the stride without a standing leg.

#include "gait/stepping.hpp"

#include <gtest/gtest.h>

namespace farrier::gait {
namespace stepping_test {

RobotPlan plan(double duty, std::vector<double> offsets) {
  constexpr const char* kNames[] = {"lf", "rf", "lh", "rh"};
  RobotPlan plan{.period_s = 0.001, .body_weight_N = 0.0, .gait = {}, .legs = {}};
  plan.gait.duty = duty;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    plan.legs.push_back({.name = kNames[i], .geometry = {}, .joints = {}, .phase_offset = offsets[i]});
  }
  return plan;
}

TEST(Stepping, OrderGroupsLegsThatStepTogether) {
  EXPECT_EQ(stepping_order(plan(0.65, {0.0, 0.5, 0.5, 0.0})), "lf+rh, rf+lh");
  EXPECT_EQ(stepping_order(plan(0.65, {0.0, 0.5, 0.0, 0.5})), "lf+lh, rf+rh");
  EXPECT_EQ(stepping_order(plan(0.8, {0.75, 0.25, 0.5, 0.0})), "rh, rf, lh, lf");
  RobotPlan standing = plan(0.65, {0.0, 0.5});
  standing.gait.pattern = Pattern::kStand;
  EXPECT_EQ(stepping_order(standing), "");
}

TEST(Stepping, FlightIsTheShareWithoutAStandingLeg) {
  EXPECT_DOUBLE_EQ(flight_share(plan(0.65, {0.0, 0.5, 0.5, 0.0})), 0.0);
  EXPECT_DOUBLE_EQ(flight_share(plan(0.8, {0.75, 0.25, 0.5, 0.0})), 0.0);
  EXPECT_NEAR(flight_share(plan(0.4, {0.0, 0.5, 0.0, 0.5})), 0.2, 1e-12);
  EXPECT_NEAR(flight_share(plan(0.65, {0.0, 0.0, 0.0, 0.0})), 0.35, 1e-12);
}

}  // namespace stepping_test
}  // namespace farrier::gait
