// HyQ trots and stands: how good its joints are as torque sources.

#include <algorithm>
#include <cmath>

#include "gait/reference.hpp"
#include "gait/schedule.hpp"
#include "tests/scenario/scenario_run.hpp"
#include "report/trot/tracking.hpp"

namespace farrier::scenario {
namespace trot_test {

// Every leg's third stride, from which a run is judged, is over here.
constexpr Tick kTicks = 4000;

report::Tracking trot(const robot::Robot& hyq, supervisor::Design design) {
  run::InprocRun settings;
  settings.ticks = kTicks;
  settings.design = design;
  return report::track(hyq, gait::Schedule(hyq.plan, settings.seed), run(hyq, settings).rows, 0);
}

// HAA motors see their leg in either phase: their load hardly changes.
bool flexes(const robot::Joint& joint) { return joint.index_in_leg > 0; }

TEST(Trot, TracksTorqueInStanceWithTheDesignForStance) {
  const robot::Robot hyq = load("hyq");
  ASSERT_EQ(hyq.bounds.stance_nrmse, 0.10);
  const report::Tracking tracking = trot(hyq, supervisor::Design::kStance);
  for (const robot::Joint& joint : hyq.joints) {
    const auto& of_joint = tracking.joints.at(joint.number);
    EXPECT_GT(of_joint.stance.ticks, 400u) << joint.name;
    EXPECT_LE(of_joint.stance.nrmse, hyq.bounds.stance_nrmse) << joint.name;
    EXPECT_EQ(of_joint.missed_ticks, 0u) << joint.name;
    if (joint.index_in_leg == 2) {
      EXPECT_GT(of_joint.travel_rad, 0.3) << joint.name << " does not walk";
    }
  }
}

// The thesis's point: gains for the light leg in the air do not hold the robot on the ground.
TEST(Trot, LosesTheTorqueInStanceWithTheDesignForSwing) {
  const robot::Robot hyq = load("hyq");
  const report::Tracking tracking = trot(hyq, supervisor::Design::kSwing);
  for (const robot::Joint& joint : hyq.joints) {
    if (flexes(joint)) {
      EXPECT_GT(tracking.joints.at(joint.number).stance.nrmse, 0.5) << joint.name;
    }
  }
}

// Touchdowns come up to 10 ms before their plan, and swing gains would lose the joint in that time.
TEST(Trot, NeverHasSwingGainsOnALegThatStands) {
  const auto unprotected_rows = [](const robot::Robot& hyq) {
    run::InprocRun settings;
    settings.ticks = kTicks;
    settings.design = supervisor::Design::kPhases;
    const Outcome outcome = run(hyq, settings);
    return std::ranges::count_if(outcome.rows, [](const trace::TraceRow& row) {
      return row.actual_phase == gait::Phase::kStance && row.phase != row.actual_phase;
    });
  };
  const robot::Robot hyq = load("hyq");
  EXPECT_EQ(unprotected_rows(hyq), 0);
  EXPECT_GT(unprotected_rows(load_with_jitter("hyq", hyq.plan.gait.touchdown_jitter_s)), 0) << "no touchdown was early";
}

// The tolerance of a joint at rest: a torque error as large as a run may have in stance, a tenth of a twentieth of the
// rating, over the stiffness of its command.
double rest_error_rad(const robot::Robot& hyq, const robot::Joint& joint) {
  const double lever = std::abs(joint.linkage.lever(joint.home_angle_rad));
  const double torque_Nm = hyq.bounds.stance_nrmse * 0.05 * report::rating_of(hyq, joint).force * lever;
  return torque_Nm / joint.stiffness_Nm_rad;
}

TEST(Stand, HoldsTheRobotStill) {
  const robot::Robot hyq = load("hyq", {gait::Pattern::kStand, std::nullopt});
  run::InprocRun settings;
  settings.ticks = 2500;
  const Outcome outcome = run(hyq, settings);
  const gait::Reference reference(hyq.plan);
  const Tick settled = settings.ticks - 1000;
  for (const trace::TraceRow& row : outcome.rows) {
    ASSERT_EQ(row.phase, gait::Phase::kStance);
    ASSERT_EQ(row.actual_phase, gait::Phase::kStance);
    if (row.tick >= settled) {
      const robot::Joint& joint = hyq.joints[row.joint];
      const double q = joint.linkage.angle(row.position_m_or_rad);
      const double q_ref = reference.at(joint.leg, joint.index_in_leg, row.tick).position_rad;
      ASSERT_NEAR(q, q_ref, rest_error_rad(hyq, joint)) << joint.name << " at tick " << row.tick;
      // No faster than its velocity sensor shows by noise alone, three sigma.
      ASSERT_LT(std::abs(row.velocity_m_s_or_rad_s), 3.0 * joint.noise.velocity) << joint.name;
    }
  }
}

}  // namespace trot_test
}  // namespace farrier::scenario
