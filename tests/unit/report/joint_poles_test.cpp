// Which gains hold which load: why a joint changes to stance gains early and to swing gains on time.

#include "run.hpp"
#include "report/trot/joint_poles.hpp"

namespace farrier::report {
namespace joint_poles_test {

// HAA motors see their leg in either phase.
bool flexes(const robot::Joint& joint) { return joint.index_in_leg > 0; }

TEST(JointPoles, OfStanceGainsAreStableOnTheSwingLoadAndOfSwingGainsUnstableOnTheStanceLoad) {
  const robot::Robot robot = testing::hyq();
  for (const robot::Joint& joint : robot.joints) {
    if (flexes(joint)) {
      const auto poles = joint_poles(joint, robot.period_s, robot.loop_delay_lockstep);
      ASSERT_TRUE(poles.ok()) << joint.name;
      EXPECT_LT(poles.value().stance_on_swing_spectral_radius, 1.0) << joint.name;
      EXPECT_GT(poles.value().swing_on_stance_spectral_radius, 1.0) << joint.name;
      RecordProperty(joint.name + "_stance_on_swing", std::to_string(poles.value().stance_on_swing_spectral_radius));
      RecordProperty(joint.name + "_swing_on_stance", std::to_string(poles.value().swing_on_stance_spectral_radius));
    }
  }
}

// With a tick of delay neither gains hold the other's load; those of stance let go far more slowly.
TEST(JointPoles, WithATickOfDelayStanceGainsGrowMoreSlowlyOnTheSwingLoadThanSwingGainsOnTheStanceLoad) {
  const robot::Robot robot = testing::hyq();
  for (const robot::Joint& joint : robot.joints) {
    if (flexes(joint)) {
      const auto poles = joint_poles(joint, robot.period_s, robot.loop_delay_realtime);
      ASSERT_TRUE(poles.ok()) << joint.name;
      EXPECT_LT(poles.value().stance_on_swing_spectral_radius, poles.value().swing_on_stance_spectral_radius)
          << joint.name;
      RecordProperty(joint.name + "_stance_on_swing", std::to_string(poles.value().stance_on_swing_spectral_radius));
      RecordProperty(joint.name + "_swing_on_stance", std::to_string(poles.value().swing_on_stance_spectral_radius));
    }
  }
}

}  // namespace joint_poles_test
}  // namespace farrier::report
