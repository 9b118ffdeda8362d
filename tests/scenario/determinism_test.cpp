// A lock-step run gives the same trace bit for bit, whatever adapts in it.

#include <algorithm>

#include "tests/scenario/scenario_run.hpp"

namespace farrier::scenario {
namespace determinism_test {

// Several strides of every leg.
constexpr Tick kStrides = 3000;
constexpr Tick kShort = 200;

run::InprocRun settings(Tick ticks, std::uint64_t seed = 3) {
  run::InprocRun run;
  run.ticks = ticks;
  run.seed = seed;
  run.design = supervisor::Design::kAdaptive;
  return run;
}

std::ptrdiff_t updates_in(const Outcome& outcome) {
  return std::ranges::count(outcome.result.decisions, signals::UpdateVerdict::kAccepted,
                            &signals::JointUpdateDecision::verdict);
}

TEST(Lockstep, GivesTheSameTraceHoweverJointsAreGrouped) {
  const robot::Robot hyq = load_with_jitter("hyq", 0.010);
  run::InprocRun grouped = settings(kStrides);
  const Outcome reference = run(hyq, grouped);
  const std::string& per_leg = reference.trace;
  ASSERT_FALSE(per_leg.empty());
  EXPECT_GE(updates_in(reference), 1) << "the traces say nothing about adaptation";
  grouped.grouping = run::Grouping::kPerJoint;
  EXPECT_TRUE(run(hyq, grouped).trace == per_leg) << "per joint";
  grouped.grouping = run::Grouping::kOne;
  EXPECT_TRUE(run(hyq, grouped).trace == per_leg) << "all in one";
}

TEST(Lockstep, GivesTheSameTraceForTheSameSeed) {
  const robot::Robot hyq = load("hyq");
  const std::string trace = run(hyq, settings(kShort)).trace;
  ASSERT_FALSE(trace.empty());
  EXPECT_TRUE(run(hyq, settings(kShort)).trace == trace);
}

TEST(Lockstep, GivesAnotherTraceForAnotherSeed) {
  const robot::Robot hyq = load("hyq");
  EXPECT_FALSE(run(hyq, settings(kShort, 3)).trace == run(hyq, settings(kShort, 4)).trace);
}

TEST(Lockstep, GivesALongerRunThatBeginsAsTheShorterOne) {
  const robot::Robot rig = load("fc1d");
  const std::string one = run(rig, settings(kShort)).trace;
  const std::string longer = run(rig, settings(2 * kShort)).trace;
  ASSERT_FALSE(one.empty());
  EXPECT_TRUE(longer.compare(0, one.size(), one) == 0);
}

}  // namespace determinism_test
}  // namespace farrier::scenario
