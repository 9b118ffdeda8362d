#include <gtest/gtest.h>

#include <cmath>

#include "core/fault.hpp"
#include "monitor/load_mass.hpp"
#include "feed.hpp"

namespace farrier::monitor {
namespace robot_view_test {

using namespace testing;

TEST(RobotView, KnowsNothingBeforeTheFirstSample) {
  Feed feed;
  const Frame frame = feed.frame();
  EXPECT_TRUE(std::isinf(frame.age_s));
  EXPECT_EQ(frame.tick, kNoTick);
  EXPECT_EQ(frame.time_s, 0.0);
  ASSERT_EQ(frame.joints.size(), hyq().joints.size());
  ASSERT_EQ(frame.phases.size(), hyq().plan.legs.size());
  EXPECT_TRUE(std::isinf(frame.joints[0].age_s));
  EXPECT_EQ(frame.joints[0].rate_Hz, 0.0);
  EXPECT_FALSE(frame.joints[0].nrmse());
  EXPECT_FALSE(frame.joints[0].mass_kg_or_kgm2);
}

TEST(RobotView, CountsControlTicksBySecondsOfItsOwnClock) {
  Feed feed;
  feed.walk(0, 100);
  EXPECT_NEAR(feed.frame().joints[5].rate_Hz, 1000.0, 1e-3);
  for (int i = 0; i < 60; ++i) {  // a robot in slow motion
    feed.pass(0.02);
    feed.walk(2000 + i * kTicksPerSummary, 1);
  }
  EXPECT_NEAR(feed.frame().joints[5].rate_Hz, 500.0, 1e-3);
}

TEST(RobotView, SaysHowLongAJointIsSilentAndForgetsItsRate) {
  Feed feed;
  feed.walk(0, 60);
  feed.pass(1.5);
  const Frame frame = feed.frame();
  EXPECT_NEAR(frame.joints[0].age_s, 1.5, 1e-9);
  EXPECT_NEAR(frame.age_s, 1.5, 1e-9);
  EXPECT_EQ(frame.joints[0].rate_Hz, 0.0);
  EXPECT_FALSE(frame.joints[0].nrmse());
}

TEST(RobotView, TracksOverTheLastSecondWeightedByTicks) {
  Feed feed;
  feed.walk(0, 60, [](signals::JointSummary& s) { s.force_error_rms_N_or_Nm = 100.0; });
  feed.walk(1200, 60);
  ASSERT_TRUE(feed.frame().joints[0].nrmse());
  EXPECT_NEAR(*feed.frame().joints[0].nrmse(), 10.0 / 200.0, 1e-12);
  feed.pass(2.0);
  feed.walk(4400, 2, [](signals::JointSummary& s) {
    s.ticks = s.tick == 4420 ? 30 : 10;
    s.force_error_rms_N_or_Nm = s.tick == 4420 ? 2.0 : 6.0;
  });
  EXPECT_NEAR(feed.frame().joints[0].force_error_rms, std::sqrt((30 * 4.0 + 10 * 36.0) / 40), 1e-12);
}

TEST(RobotView, CountsTicksThatWereNotStepped) {
  Feed feed;
  feed.walk(0, 10);
  EXPECT_EQ(feed.frame().joints[0].missed_ticks, 0u);
  feed.walk(200, 1, [](signals::JointSummary& s) { s.ticks = 17; });
  EXPECT_EQ(feed.frame().joints[0].missed_ticks, 3u);
}

TEST(RobotView, ShowsAJointThatTellsItsLastTickAgain) {
  Feed feed;
  feed.walk(0, 60);
  feed.frame();
  for (int i = 0; i < 60; ++i) {  // 1.2 s without sensors
    feed.walk(1180, 1, [](signals::JointSummary& s) {
      s.ticks = 0;
      s.faults = static_cast<std::uint32_t>(Fault::kSensorsStale);
      s.force_error_rms_N_or_Nm = s.force_reference_rms_N_or_Nm = 0.0;
    });
  }
  const Frame frame = feed.frame();
  EXPECT_LT(frame.joints[0].age_s, 0.03);
  EXPECT_EQ(frame.joints[0].rate_Hz, 0.0);
  EXPECT_EQ(frame.joints[0].missed_ticks, 0u);
  EXPECT_FALSE(frame.joints[0].nrmse());
  EXPECT_TRUE(FaultSet(frame.joints[0].faults).has(Fault::kSensorsStale));
}

TEST(RobotView, CountsNoTicksOfASummaryThatWasLost) {
  Feed feed;
  feed.walk(0, 10);
  feed.walk(220, 10);  // the one of tick 220 never came
  EXPECT_EQ(feed.frame().joints[0].missed_ticks, 0u);
}

TEST(RobotView, HandsSummariesFaultsAndEventsOverOnce) {
  Feed feed;
  feed.walk(0, 1, [](signals::JointSummary& s) { s.faults = static_cast<std::uint32_t>(Fault::kCommandStale); });
  feed.walk(20, 1);
  feed.view().note(signals::Severity::kWarning, "look", feed.now_ns());
  const Frame first = feed.frame();
  EXPECT_EQ(first.joints[0].summaries.size(), 2u);
  EXPECT_TRUE(FaultSet(first.joints[0].faults).has(Fault::kCommandStale));
  ASSERT_EQ(first.events.size(), 1u);
  EXPECT_EQ(first.events[0].who, "monitor");
  const Frame second = feed.frame();
  EXPECT_TRUE(second.joints[0].summaries.empty());
  EXPECT_EQ(second.joints[0].faults, 0u);
  EXPECT_TRUE(second.events.empty());
  feed.view().note(signals::Severity::kInfo, "again", feed.now_ns());
  EXPECT_EQ(feed.frame().events.at(0).number, 1u);
}

TEST(RobotView, NamesProcessAndJointOfAnEvent) {
  Feed feed;
  walk_for_a_second(feed);
  const Frame frame = feed.frame();
  ASSERT_EQ(frame.events.size(), 2u);
  EXPECT_EQ(frame.events[0].who, "supervisor");
  EXPECT_EQ(frame.events[0].joint, "");
  EXPECT_EQ(frame.events[1].joint, hyq().joints[2].name);
  EXPECT_EQ(frame.events[1].text, "design refused");
  EXPECT_EQ(frame.events[1].severity, signals::Severity::kError);
}

TEST(RobotView, BeginsAgainWithAnotherSession) {
  Feed feed;
  walk_for_a_second(feed);
  feed.take(hello(0, "sim_bridge", kSession + 1));
  const Frame frame = feed.frame();
  EXPECT_EQ(frame.tick, kNoTick);
  EXPECT_EQ(frame.mode.epoch, 0u);
  EXPECT_EQ(frame.joints[0].newest.tick, kNoTick);
  EXPECT_EQ(frame.participants.size(), 1u);
  ASSERT_EQ(frame.events.size(), 3u);
  EXPECT_EQ(frame.events[2].text, "another run begins: session 78");
}

TEST(RobotView, LeavesOutWhatTheRobotDoesNotHave) {
  Feed feed;
  const auto joints = static_cast<std::uint16_t>(hyq().joints.size());
  feed.take(summary(joints, 20));
  feed.take(estimate(joints, 20, 5.0));
  signals::GaitPhase phase;
  phase.leg = 9;
  phase.announced_tick = 1;
  feed.take(phase);
  phase.leg = 0;
  phase.phase = static_cast<signals::Phase>(2);
  phase.switch_tick = 0;
  feed.take(phase);
  feed.take(hello(5000, "nobody"));
  feed.take(summary(0, kNoTick));  // a probe of the greeting
  feed.take_bytes(bus::TopicId::kJointSummary, {0, 1, 0, 0, 7});
  feed.take_bytes(bus::TopicId::kSystemEvent, {});
  const Frame frame = feed.frame();
  EXPECT_EQ(frame.tick, kNoTick);
  EXPECT_TRUE(frame.participants.empty());
  EXPECT_TRUE(frame.events.empty());
  EXPECT_TRUE(std::isinf(frame.joints[0].age_s));
  EXPECT_EQ(frame.phases[0], signals::Phase::kStance);
}

TEST(RobotView, HasPolesLargestFirstAndTheMassOfTheEstimate) {
  Feed feed;
  walk_for_a_second(feed);
  const Frame frame = feed.frame();
  for (const robot::Joint& joint : hyq().joints) {
    const JointFrame& shown = frame.joints[joint.number];
    EXPECT_GE(std::abs(shown.poles[0]), std::abs(shown.poles[1]));
    EXPECT_GE(std::abs(shown.poles[1]), std::abs(shown.poles[2]));
    ASSERT_TRUE(shown.mass_kg_or_kgm2);
    EXPECT_NEAR(*shown.mass_kg_or_kgm2, 5.0 + joint.number, 1e-6);
  }
}

TEST(LoadMass, IsThatOfTheModelFromLightToHeavy) {
  for (const double mass : {1.0, 5.0, 50.0, 500.0}) {
    const auto found = load_mass(estimate(0, 1, mass), hyq().period_s);
    ASSERT_TRUE(found) << mass;
    EXPECT_NEAR(*found / mass, 1.0, 1e-6);
  }
}

TEST(LoadMass, IsThatOfThePhysicsWhereTheEstimatorKnowsThem) {
  signals::JointModelEstimateCopy e = estimate(0, 1, 5.0);
  e.has_physics = 1;
  e.physics[0] = 7.5;
  EXPECT_EQ(load_mass(e, 1e-3), 7.5);
}

TEST(LoadMass, IsUnknownForAModelThatNothingContinuousHas) {
  EXPECT_FALSE(load_mass({}, 1e-3));
  signals::JointModelEstimateCopy e = estimate(0, 1, 5.0);
  e.a = {-1.0, 0, 0, 0, -0.5, 0.1, 0, 0.1, 0.5};
  EXPECT_FALSE(load_mass(e, 1e-3));
  e.a[4] = NAN;
  EXPECT_FALSE(load_mass(e, 1e-3));
  e = estimate(0, 1, 5.0);
  for (const std::size_t i : {3, 4, 5}) {
    e.a[i] = i == 4 ? e.a[i] : -e.a[i];  // pushes the wrong way
  }
  EXPECT_FALSE(load_mass(e, 1e-3));
}

/// At rest on its feet: summaries of joints in their home pose.
void walk_at_home(Feed& feed, Tick begin, int summaries) {
  feed.walk(begin, summaries, [](signals::JointSummary& s) {
    const robot::Joint& joint = hyq().joints[s.joint];
    s.position_m_or_rad = joint.linkage.position(joint.home_angle_rad);
  });
}

signals::BodyTruth truth(Tick tick) {
  signals::BodyTruth truth;
  truth.tick = tick;
  truth.attitude = {1.0, 0.0, 0.0, 0.0};
  truth.position_m = {1e-3 * static_cast<double>(tick), 0.0, 0.5};
  return truth;
}

TEST(RobotView, PlacesLegsWhereTheJointsAre) {
  Feed feed;
  EXPECT_FALSE(feed.frame().body.value().legs.at(0));
  walk_at_home(feed, 0, 1);
  const BodyFrame body = feed.frame().body.value();
  ASSERT_EQ(body.legs.size(), 4u);
  auto placed = body::RigidBody::create(*hyq().body).value();
  auto home = body::BodyState::zero(12);
  for (const robot::Joint& joint : hyq().joints) {
    home.angles_rad[joint.number] = joint.home_angle_rad;
  }
  placed.set_state(home);
  constexpr double kLinkage_m = 1e-9;  // an angle from a cylinder's length
  for (int leg = 0; leg < 4; ++leg) {
    const BodyFrame::Leg& seen = body.legs[static_cast<std::size_t>(leg)].value();
    EXPECT_LT((seen.foot_m - placed.foot_position_m(leg)).norm(), kLinkage_m) << leg;
    EXPECT_EQ(seen.hinges_m[0], hyq().body->legs[static_cast<std::size_t>(leg)].links[0].hinge_m) << leg;
  }
  EXPECT_FALSE(body.truth);
  EXPECT_FALSE(body.state);
}

TEST(RobotView, ShowsTrunkAndLegsOfOneTick) {
  Feed feed;
  for (Tick tick = 1; tick <= 30; ++tick) {
    feed.take(truth(tick));
  }
  walk_at_home(feed, 0, 1);  // of tick 20
  EXPECT_EQ(feed.frame().body->truth.value().tick, 20);
  walk_at_home(feed, 20, 1);
  EXPECT_EQ(feed.frame().body->truth.value().tick, 30);
}

TEST(RobotView, ForgetsABodyThatNobodySpeaksOfAnyMore) {
  Feed feed;
  signals::BodyState state;
  state.tick = 20;
  feed.take(truth(20));
  feed.take(state);
  walk_at_home(feed, 0, 1);
  EXPECT_TRUE(feed.frame().body->truth && feed.frame().body->state);
  feed.pass(1.1 * kSilent_s);
  EXPECT_FALSE(feed.frame().body->truth || feed.frame().body->state);
  feed.take(truth(2000));
  feed.take(hello(0, "sim_bridge"));
  feed.take(hello(0, "sim_bridge", kSession + 1));
  EXPECT_FALSE(feed.frame().body->truth) << "another run";
}

}  // namespace robot_view_test
}  // namespace farrier::monitor
