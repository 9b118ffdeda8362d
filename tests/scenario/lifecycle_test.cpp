// From the first tick to the last report.

#include "gait/schedule.hpp"
#include "tests/scenario/scenario_run.hpp"

namespace farrier::scenario {
namespace lifecycle_test {

using signals::JointState;

class ShortRun : public ::testing::Test {
 protected:
  static constexpr Tick kTicks = 250;

  static void SetUpTestSuite() {
    run::InprocRun settings;
    settings.ticks = kTicks;
    outcome_ = new Outcome(run(hyq(), settings));
  }
  static void TearDownTestSuite() { delete outcome_; }

  static const robot::Robot& hyq() {
    static const robot::Robot robot = load("hyq");
    return robot;
  }
  static const trace::TraceRow& row(Tick tick, std::size_t joint) {
    return outcome_->at(tick, joint, hyq().joints.size());
  }

  static Outcome* outcome_;
};
Outcome* ShortRun::outcome_ = nullptr;

TEST_F(ShortRun, StartsWithShutValves) {
  for (Tick tick = 0; tick < hyq().update_logic.gain_lead_ticks; ++tick) {
    for (std::size_t joint = 0; joint < hyq().joints.size(); ++joint) {
      EXPECT_EQ(row(tick, joint).state, JointState::kNull);
      EXPECT_EQ(row(tick, joint).valve_current_A, 0.0);
      EXPECT_EQ(row(tick, joint).generation, 0u);
      EXPECT_TRUE(FaultSet(row(tick, joint).faults).has(Fault::kDisarmed));
    }
  }
}

TEST_F(ShortRun, ArmsEveryJointAtTheSupervisorsEffectiveTick) {
  for (std::size_t joint = 0; joint < hyq().joints.size(); ++joint) {
    const auto& armed = row(hyq().update_logic.gain_lead_ticks, joint);
    EXPECT_EQ(armed.state, JointState::kTracking) << hyq().joints[joint].name;
    EXPECT_EQ(armed.generation, 2u) << "stance gains are the second issue";
  }
}

TEST_F(ShortRun, LacksNothingOnceArmed) {
  for (const trace::TraceRow& row : outcome_->rows) {
    if (row.tick >= hyq().update_logic.gain_lead_ticks) {
      ASSERT_EQ(FaultSet(row.faults), FaultSet{}) << to_string(FaultSet(row.faults)) << " at tick " << row.tick;
      ASSERT_EQ(row.command_age_ticks, 0u) << "the command that answers tick k acts from tick k";
    }
  }
}

TEST_F(ShortRun, GetsAHelloAndAFinalReportFromEverybody) {
  const auto members = run::plan_members(hyq(), run::Grouping::kPerLeg);
  ASSERT_EQ(outcome_->result.hellos.size(), members.size());
  ASSERT_EQ(outcome_->result.healths.size(), members.size());
  for (const run::Member& member : members) {
    EXPECT_EQ(signals::text_of(outcome_->result.hellos[member.number].name), member.name);
    EXPECT_EQ(outcome_->result.healths[member.number].final_report, 1) << member.name;
    EXPECT_EQ(outcome_->result.healths[member.number].tick, kTicks) << member.name;
  }
}

TEST_F(ShortRun, TellsWhyEachJointWasNullAndWhenItWasWell) {
  std::vector<std::vector<std::string>> told(hyq().joints.size());
  for (const signals::SystemEvent& event : outcome_->result.events) {
    told.at(event.joint).push_back(std::to_string(event.tick) + " " + std::string(signals::text_of(event.text)));
  }
  const std::string armed = std::to_string(hyq().update_logic.gain_lead_ticks) + " no fault";
  for (const auto& of_joint : told) {
    EXPECT_EQ(of_joint, (std::vector<std::string>{"0 disarmed, no gains", armed}));
  }
}

TEST_F(ShortRun, LosesNothingOnTheBus) {
  std::uint64_t valves_sent = 0, valves_received = 0;
  constexpr auto kValves = static_cast<std::size_t>(bus::TopicId::kJointValveCommand);
  for (const signals::SystemHealth& health : outcome_->result.healths) {
    for (const std::uint64_t lost : health.lost) {
      EXPECT_EQ(lost, 0u);
    }
    valves_sent += health.sent[kValves];
    valves_received += health.received[kValves];
  }
  EXPECT_EQ(valves_sent, static_cast<std::uint64_t>(kTicks) * hyq().joints.size());
  EXPECT_EQ(valves_received, valves_sent);
}

TEST(InprocRun, EndsWhenItIsInterrupted) {
  run::InprocRun settings;
  settings.ticks = 1000;
  settings.progress = [](Tick tick) { return tick < 200; };
  const auto interrupted = run::run_inproc(load("fc1d"), settings);
  ASSERT_FALSE(interrupted);
  EXPECT_EQ(interrupted.error().message, "interrupted");
}

TEST(InprocRun, RefusesATraceItCannotWrite) {
  run::InprocRun settings;
  settings.ticks = 10;
  settings.trace_path = "/nowhere/at/all.csv";
  const auto refused = run::run_inproc(load("fc1d"), settings);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("/nowhere/at/all.csv"), std::string::npos);
}

TEST(PlanMembers, HostsEveryJointOnceInEveryGrouping) {
  const robot::Robot hyq = load("hyq");
  const std::vector<std::pair<run::Grouping, std::size_t>> nodes{
      {run::Grouping::kPerLeg, 4}, {run::Grouping::kPerJoint, 12}, {run::Grouping::kOne, 1}};
  for (const auto& [grouping, expected] : nodes) {
    const auto members = run::plan_members(hyq, grouping);
    EXPECT_EQ(members.size(), participant::kFirstJointNode + expected);
    std::vector<std::string> hosted;
    for (std::size_t i = 0; i < members.size(); ++i) {
      EXPECT_EQ(members[i].number, i);
      hosted.insert(hosted.end(), members[i].joints.begin(), members[i].joints.end());
    }
    EXPECT_EQ(hosted, robot::joint_names(hyq));
  }
}

}  // namespace lifecycle_test
}  // namespace farrier::scenario
