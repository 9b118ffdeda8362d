// HyQ trots with gains that begin with the light leg in the air and follow what is estimated.

#include <optional>

#include "core/median.hpp"
#include "gait/schedule.hpp"
#include "tests/scenario/scenario_run.hpp"
#include "report/trot/tracking.hpp"

namespace farrier::scenario {
namespace adaptive_trot_test {

using signals::UpdateVerdict;

constexpr Tick kTrot = 9000;
constexpr Tick kLater = 6000;
constexpr Tick kShort = 3000;
constexpr int kFewestUpdates = 3;
constexpr double kNoWorse = 1.05;  // error after over error before, median over the joints
constexpr double kNoWorseForAny = 1.25;

run::InprocRun adaptive(Tick ticks) {
  run::InprocRun run;
  run.ticks = ticks;
  run.seed = 3;
  run.design = supervisor::Design::kAdaptive;
  return run;
}

class AdaptiveTrot : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    hyq_.emplace(load("hyq"));
    outcome_.emplace(run(*hyq_, adaptive(kTrot)));
  }
  static void TearDownTestSuite() {
    outcome_.reset();
    hyq_.reset();
  }

  static int updates(const robot::Joint& joint) {
    int accepted = 0;
    for (const signals::JointUpdateDecision& decision : outcome_->result.decisions) {
      accepted += decision.joint == joint.number && decision.verdict == UpdateVerdict::kAccepted ? 1 : 0;
    }
    return accepted;
  }

  /// Tracking in the ticks from `from` to before `to`, from the third stride on.
  static report::Tracking tracking_between(Tick from, Tick to) {
    std::vector<trace::TraceRow> rows = outcome_->rows;
    std::erase_if(rows, [&](const trace::TraceRow& row) { return row.tick < from || row.tick >= to; });
    const gait::Schedule schedule(hyq_->plan, adaptive(kTrot).seed);
    return report::track(*hyq_, schedule, rows, 0);
  }

  static void expect_tracking(Tick from) {
    ASSERT_EQ(hyq_->bounds.stance_nrmse, 0.10);
    const report::Tracking tracking = tracking_between(from, kTrot);
    for (const robot::Joint& joint : hyq_->joints) {
      const report::JointTracking& of_joint = tracking.joints.at(joint.number);
      EXPECT_LE(of_joint.stance.nrmse, hyq_->bounds.stance_nrmse) << joint.name << " after " << updates(joint);
      EXPECT_EQ(of_joint.not_tracking_ticks, 0u) << joint.name;
      EXPECT_FALSE(of_joint.tripped) << joint.name;
    }
  }

  static std::optional<robot::Robot> hyq_;
  static std::optional<Outcome> outcome_;
};
std::optional<robot::Robot> AdaptiveTrot::hyq_;
std::optional<Outcome> AdaptiveTrot::outcome_;

TEST_F(AdaptiveTrot, RedesignsEveryJointThatFlexesUnderTheRobot) {
  for (const robot::Joint& joint : hyq_->joints) {
    if (joint.index_in_leg > 0) {
      EXPECT_GE(updates(joint), kFewestUpdates) << joint.name;
    }
  }
}

TEST_F(AdaptiveTrot, TracksTorqueInStanceFromTheThirdStrideOnAsWellAsIsAskedOfADesignForStance) { expect_tracking(0); }

// The same joints in the same run, before and after most of their updates.
TEST_F(AdaptiveTrot, TracksTorqueInStanceNoWorseAfterMoreUpdates) {
  expect_tracking(kLater);
  const report::Tracking early = tracking_between(0, kLater);
  const report::Tracking late = tracking_between(kLater, kTrot);
  std::vector<double> ratios;
  for (const robot::Joint& joint : hyq_->joints) {
    ratios.push_back(late.joints.at(joint.number).stance.nrmse / early.joints.at(joint.number).stance.nrmse);
    EXPECT_LE(ratios.back(), kNoWorseForAny) << joint.name;
  }
  EXPECT_LE(median(ratios), kNoWorse);
}

TEST_F(AdaptiveTrot, PublishesGainsForEveryAcceptedUpdate) {
  std::size_t accepted = 0;
  for (const signals::JointUpdateDecision& decision : outcome_->result.decisions) {
    accepted += decision.verdict == UpdateVerdict::kAccepted ? 1u : 0u;
  }
  EXPECT_EQ(outcome_->result.gains.size(), 2u * hyq_->joints.size() + accepted) << "the first ones, and one each";
}

TEST(AdaptiveLockstep, GivesTheSameTraceAndDecisionsHoweverJointsAreGrouped) {
  const robot::Robot hyq = load("hyq");
  run::InprocRun grouped = adaptive(kShort);
  const Outcome per_leg = run(hyq, grouped);
  grouped.grouping = run::Grouping::kOne;
  const Outcome one = run(hyq, grouped);
  ASSERT_FALSE(per_leg.trace.empty());
  EXPECT_TRUE(one.trace == per_leg.trace);
  const auto& decisions = per_leg.result.decisions;
  ASSERT_EQ(one.result.decisions.size(), decisions.size());
  EXPECT_GT(decisions.size(), 0u);
  for (std::size_t i = 0; i < decisions.size(); ++i) {
    EXPECT_EQ(one.result.decisions[i].tick, decisions[i].tick);
    EXPECT_EQ(one.result.decisions[i].joint, decisions[i].joint);
    EXPECT_EQ(one.result.decisions[i].pole_distance, decisions[i].pole_distance);
  }
}

}  // namespace adaptive_trot_test
}  // namespace farrier::scenario
