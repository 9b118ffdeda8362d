// Laws tried by simulation, and what adaptation begins with behind filters.

#include <gtest/gtest.h>

#include "robot/joint_model.hpp"
#include "supervisor/first_gains.hpp"
#include "supervisor/joint_design.hpp"
#include "supervisor/law_check.hpp"
#include "estimates.hpp"

namespace farrier::supervisor {
namespace law_check_test {

using namespace testing;

constexpr std::array kNonlinear{control::Kind::kFeedbackLinearisation, control::Kind::kPid,
                                control::Kind::kFlowInversion};

robot::Joint knee_behind(double force_filter_Hz, control::Kind kind) {
  robot::Joint knee = *hyq().find("lf_kfe");
  knee.kind = kind;
  knee.sensors.force.cut_off_Hz = force_filter_Hz;
  return knee;
}

bool settles(const robot::Joint& joint, const plant::LoadParams& load) {
  const plant::JointPhysics physics = robot::nominal_physics(joint, load);
  return LawCheck(joint, hyq().period_s, kNoDelay).settles(physics, physics);
}

TEST(LawCheck, PassesTheLawsOfTheFileOnTheLoadsOfTheFile) {
  for (robot::Joint joint : hyq().joints) {
    for (const control::Kind kind : kNonlinear) {
      joint.kind = kind;
      EXPECT_TRUE(settles(joint, joint.swing_load)) << joint.name;
      EXPECT_TRUE(settles(joint, joint.stance_load)) << joint.name;
    }
  }
}

TEST(LawCheck, FindsLawsThatASlowForceMakesUnstable) {
  for (const control::Kind kind : kNonlinear) {
    const robot::Joint knee = knee_behind(40.0, kind);
    EXPECT_FALSE(settles(knee, knee.stance_load));
  }
}

TEST(LawCheck, JudgesLinearGainsAsTheirClosedLoopIs) {
  const robot::Joint knee = knee_behind(0.0, control::Kind::kLqr);
  const LawCheck check(knee, hyq().period_s, kNoDelay);
  const control::Gains stance = design_joint(knee, knee.stance_load, hyq().period_s, kNoDelay).value();
  const control::Gains swing = design_joint(knee, knee.swing_load, hyq().period_s, kNoDelay).value();
  EXPECT_TRUE(check.settles(stance, robot::nominal_physics(knee, knee.stance_load)));
  EXPECT_FALSE(check.settles(swing, robot::nominal_physics(knee, knee.stance_load)));
}

TEST(DesignJoint, RefusesALawThatDoesNotSettleBehindFiltersByName) {
  const robot::Joint knee = knee_behind(40.0, control::Kind::kPid);
  const auto gains = design_joint(knee, knee.stance_load, hyq().period_s, kNoDelay);
  ASSERT_FALSE(gains.ok());
  EXPECT_NE(gains.error().message.find("lf_kfe: its controller does not settle on a load of 50"), std::string::npos)
      << gains.error().message;
  EXPECT_NE(gains.error().message.find("force filter 40 Hz: raise the cut-offs"), std::string::npos);
}

TEST(FirstGains, OfAdaptationAreEachPhasesOwnBehindFiltersOnly) {
  const auto first = [](double force_filter_Hz) {
    return design_slots(knee_behind(force_filter_Hz, control::Kind::kLqr), Design::kAdaptive, hyq().period_s, kNoDelay)
        .value();
  };
  const SlotGains bare = first(0.0);
  EXPECT_EQ(bare[0].force, bare[1].force);
  const SlotGains filtered = first(300.0);
  EXPECT_EQ(filtered[0].force, bare[0].force);
  EXPECT_NE(filtered[1].force, filtered[0].force);
}

}  // namespace law_check_test
}  // namespace farrier::supervisor
