#include <gtest/gtest.h>

#include "supervisor/joint_design.hpp"
#include "supervisor/supervisor.hpp"
#include "tests/support/allocation_guard.hpp"
#include "tests/unit/robot/test_files.hpp"

namespace farrier::supervisor {
namespace known_loads_test {

using signals::JointControllerGains;

constexpr std::uint64_t kSession = 31;
constexpr Tick kFirst = 20;
constexpr Tick kSecond = 50;

const robot::Robot& hyq() {
  static const robot::Robot robot = robot::load_shipped("hyq");
  return robot;
}

plant::LoadParams of_mass(double mass) { return {.mass = mass, .damping = 500.0}; }

Supervisor told_of(std::vector<robot::LoadChange> loads) {
  return Supervisor::create(hyq(), Design::kSwing, 0, kSession, std::move(loads)).value();
}

/// Everything issued after the first step.
std::vector<JointControllerGains> issued_later(Supervisor& supervisor) {
  supervisor.step(0);
  std::vector<JointControllerGains> issued;
  for (Tick tick = 1; tick < 100; ++tick) {
    for (const JointControllerGains& gains : supervisor.step(tick).gains) {
      issued.push_back(gains);
    }
  }
  return issued;
}

TEST(SupervisorKnownLoads, GetTheirGainsInBothSlotsExactlyAtTheirTick) {
  Supervisor supervisor = told_of({{kSecond, 2, of_mass(7.0)}, {kFirst, 2, of_mass(20.0)}});
  const auto issued = issued_later(supervisor);
  ASSERT_EQ(issued.size(), 4u);
  for (std::size_t i = 0; i < issued.size(); ++i) {
    const double mass = i < 2 ? 20.0 : 7.0;
    EXPECT_EQ(issued[i].effective_tick, i < 2 ? kFirst : kSecond);
    EXPECT_EQ(issued[i].phase, i % 2 == 0 ? signals::Phase::kSwing : signals::Phase::kStance);
    EXPECT_EQ(issued[i].generation, 3 + i) << "after the two of the start";
    EXPECT_EQ(issued[i].k_force, design_joint(hyq().joints[2], of_mass(mass), hyq().period_s, 0).value().force);
  }
}

TEST(SupervisorKnownLoads, OfSeveralJointsChangeTogether) {
  Supervisor supervisor = told_of({{kFirst, 1, of_mass(20.0)}, {kFirst, 2, of_mass(20.0)}});
  const auto issued = issued_later(supervisor);
  ASSERT_EQ(issued.size(), 4u);
  for (const JointControllerGains& gains : issued) {
    EXPECT_EQ(gains.effective_tick, kFirst);
  }
}

TEST(SupervisorKnownLoads, FromTheStartActAsSoonAsTheyCan) {
  Supervisor supervisor = told_of({{0, 2, of_mass(20.0)}});
  const auto issued = issued_later(supervisor);
  ASSERT_EQ(issued.size(), 2u);
  EXPECT_EQ(issued[0].effective_tick, 1 + hyq().update_logic.gain_lead_ticks) << "the step after the first design";
}

TEST(SupervisorKnownLoads, AreRefusedForAJointTheRobotDoesNotHave) {
  EXPECT_FALSE(Supervisor::create(hyq(), Design::kSwing, 0, kSession, {{0, 12, of_mass(1.0)}}));
}

TEST(SupervisorKnownLoads, AreHandedOutWithoutAllocation) {
  Supervisor supervisor = told_of({{kFirst, 2, of_mass(20.0)}});
  const test::AllocationGuard guard;
  for (Tick tick = 0; tick < 100; ++tick) {
    supervisor.step(tick);
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

}  // namespace known_loads_test
}  // namespace farrier::supervisor
