// Estimates and decisions find their way, whatever the estimator and the supervisor make of them.

#include "run/run_monitor.hpp"
#include "tests/scenario/scenario_run.hpp"
#include "tests/unit/participant/run.hpp"

namespace farrier::scenario {
namespace adaptation_wiring_test {

using signals::JointUpdateDecision;

class EstimatePeriod : public ::testing::TestWithParam<int> {};

TEST_P(EstimatePeriod, IsKeptByBothSidesInLockStep) {
  constexpr Tick kTicks = 101;
  robot::Robot rig = load("fc1d");
  rig.estimate_period_ticks = GetParam();
  run::InprocRun settings;
  settings.ticks = kTicks;
  const auto result = run::run_inproc(rig, settings);
  ASSERT_TRUE(result) << result.error().message;
  std::uint64_t due = 0, due_before_the_last_tick = 0;
  for (Tick tick = 0; tick < kTicks; ++tick) {
    due += rig.estimate_due(tick) ? 1 : 0;
    due_before_the_last_tick += rig.estimate_due(tick) && tick < kTicks - 1 ? 1 : 0;
  }
  constexpr auto kEstimates = static_cast<std::size_t>(bus::TopicId::kJointModelEstimate);
  const auto& healths = result.value().healths;
  EXPECT_EQ(healths[participant::kEstimatorService].sent[kEstimates], due);
  EXPECT_GE(healths[participant::kSupervisor].received[kEstimates], due_before_the_last_tick);
}

INSTANTIATE_TEST_SUITE_P(Ticks, EstimatePeriod, ::testing::Values(1, 3, 10, 1000));

JointUpdateDecision decision(std::uint16_t joint, Tick tick) {
  JointUpdateDecision decision;
  decision.joint = joint;
  decision.tick = tick;
  decision.verdict = signals::UpdateVerdict::kDesignRefused;
  return decision;
}

class Monitor : public ::testing::TestWithParam<bus::ClockKind> {
 protected:
  participant::Identity identity(std::uint16_t number, const char* name) const {
    participant::Identity identity = run_.identity(number, name);
    identity.clock = GetParam();
    return identity;
  }

  participant::testing::TestRun run_{2};
  participant::testing::Member supervisor_ = run_.join(identity(0, "supervisor"));
  participant::Out<JointUpdateDecision>* out_ =
      participant::testing::opened(supervisor_->publish<JointUpdateDecision>({0, 1}));
};

TEST_P(Monitor, CollectsDecisionsButNoProbes) {
  const auto bus = run_.bus();
  auto monitor = run::RunMonitor::create(*bus, identity(1, "locomotion"));
  ASSERT_TRUE(monitor.ok());
  out_->probe();
  out_->publish(decision(1, 500));
  monitor.value().poll();
  out_->publish(decision(0, 700));
  monitor.value().poll();
  ASSERT_EQ(monitor.value().decisions().size(), 2u);
  EXPECT_EQ(monitor.value().decisions()[0].joint, 1);
  EXPECT_EQ(monitor.value().decisions()[0].tick, 500);
  EXPECT_EQ(monitor.value().decisions()[1].tick, 700);
  EXPECT_EQ(monitor.value().decisions()[1].verdict, signals::UpdateVerdict::kDesignRefused);
}

TEST_P(Monitor, ThatJoinsLateGetsTheLast64DecisionsOfEachJoint) {
  constexpr Tick kDecisions = 64, kTooOld = 6;
  for (Tick tick = 0; tick < kDecisions + kTooOld; ++tick) {
    out_->publish(decision(0, tick));
  }
  out_->publish(decision(1, 3));
  const auto bus = run_.bus();
  auto monitor = run::RunMonitor::create(*bus, identity(1, "locomotion"));
  ASSERT_TRUE(monitor.ok());
  monitor.value().poll();
  std::vector<Tick> ticks;
  for (const JointUpdateDecision& got : monitor.value().decisions()) {
    if (got.joint == 0) {
      ticks.push_back(got.tick);
    }
  }
  ASSERT_EQ(ticks.size(), static_cast<std::size_t>(kDecisions));
  EXPECT_EQ(ticks.front(), kTooOld);
  EXPECT_EQ(monitor.value().decisions().size(), static_cast<std::size_t>(kDecisions) + 1);
}

INSTANTIATE_TEST_SUITE_P(Clocks, Monitor, ::testing::Values(bus::ClockKind::kLockstep, bus::ClockKind::kRealtime));

}  // namespace adaptation_wiring_test
}  // namespace farrier::scenario
