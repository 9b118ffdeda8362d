#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "locomotion/foothold.hpp"
#include "locomotion/ground_plane.hpp"
#include "locomotion/leg_sequencer.hpp"
#include "locomotion/phase_announcer.hpp"
#include "locomotion/rotation.hpp"
#include "locomotion/swing_trajectory.hpp"
#include "locomotion/trot_schedule.hpp"
#include "locomotion/trunk_wrench.hpp"
#include "tests/unit/gait/plan.hpp"

namespace farrier::locomotion {
namespace planning_test {

constexpr double kPeriod_s = 0.001;
constexpr int kLegs = 4;

TEST(TrotSchedule, StandsUntilItStarts) {
  TrotSchedule schedule(gait::hyq_plan());
  for (Tick tick = 0; tick < 3000; ++tick) {
    schedule.step(tick);
    for (int leg = 0; leg < kLegs; ++leg) {
      ASSERT_EQ(schedule.phase(leg), Phase::kStance);
      ASSERT_FALSE(schedule.announcement(leg));
    }
  }
  EXPECT_FALSE(schedule.walking());
}

TEST(TrotSchedule, SwitchesWhenItAnnouncedAndStopsWithAllFeetOnTheGround) {
  constexpr Tick kStart = 1234;
  for (Tick stop_at = 3000; stop_at < 3720; stop_at += 90) {
    TrotSchedule trot(gait::hyq_plan());
    PerLeg<std::optional<gait::PhaseSwitch>> due;
    PerLeg<Phase> phase;
    phase.fill(Phase::kStance);
    int switches = 0;
    for (Tick tick = 0; tick < stop_at + 1500; ++tick) {
      if (tick == kStart) {
        trot.start(tick);
      }
      if (tick == stop_at) {
        trot.stop();
      }
      trot.step(tick);
      for (int leg = 0; leg < kLegs; ++leg) {
        if (trot.phase(leg) != phase[leg]) {
          ASSERT_TRUE(due[leg]) << "leg " << leg << " tick " << tick;
          ASSERT_EQ(due[leg]->tick, tick);
          ASSERT_EQ(due[leg]->phase, trot.phase(leg));
          phase[leg] = trot.phase(leg);
          ++switches;
        }
        if (trot.announcement(leg)) {
          due[leg] = trot.announcement(leg);
        }
      }
    }
    EXPECT_FALSE(trot.walking());
    EXPECT_GT(switches, 8);
    for (int leg = 0; leg < kLegs; ++leg) {
      EXPECT_EQ(trot.phase(leg), Phase::kStance);
      EXPECT_EQ(trot.stance_progress(leg), 0.5);
    }
  }
}

TEST(Foothold, LiesUnderTheHipAtRestAndHalfAStanceAheadInMotion) {
  FootholdInput input{.hip_m = {0.4, 0.3, 0.0},
                      .from_trunk_m = {0.4, 0.3, 0.0},
                      .velocity_m_s = Eigen::Vector3d::Zero(),
                      .wanted_velocity_m_s = Eigen::Vector3d::Zero(),
                      .wanted_yaw_rate_rad_s = 0.0,
                      .rest_s = 0.1,
                      .stance_s = 0.4};
  EXPECT_EQ(foothold({}, input), input.hip_m);
  input.velocity_m_s = input.wanted_velocity_m_s = {0.5, 0.0, 0.0};
  EXPECT_NEAR(foothold({}, input).x(), 0.4 + 0.05 + 0.1, 1e-12);
  input.velocity_m_s.setZero();
  input.wanted_velocity_m_s.setZero();
  input.wanted_yaw_rate_rad_s = 1.0;
  const Eigen::Vector3d turned = foothold({}, input);
  EXPECT_NEAR(turned.x(), 0.4 - 0.3 * 0.3, 1e-12);
  EXPECT_NEAR(turned.y(), 0.3 + 0.4 * 0.3, 1e-12);
}

TEST(Foothold, StaysWithinReach) {
  const FootholdParams params;
  const Eigen::Vector3d place = foothold(params, {.hip_m = Eigen::Vector3d::Zero(),
                                                  .from_trunk_m = Eigen::Vector3d::Zero(),
                                                  .velocity_m_s = {9.0, -9.0, 0.0},
                                                  .wanted_velocity_m_s = Eigen::Vector3d::Zero(),
                                                  .wanted_yaw_rate_rad_s = 0.0,
                                                  .rest_s = 0.0,
                                                  .stance_s = 0.4});
  EXPECT_EQ(place.x(), params.reach_m);
  EXPECT_EQ(place.y(), -params.reach_m);
}

TEST(SwingTrajectory, IsSmoothFromLiftOffOverTheApexIntoTheReach) {
  const SwingParams params{.forward_share = 0.9};
  SwingTrajectory swing(params);
  const Eigen::Vector3d from{0.0, 0.0, 0.02}, to{0.3, 0.05, 0.07};
  swing.lift_off(from);
  constexpr double kSwing_s = 0.25, kStep = 1e-4;
  EXPECT_LT((swing.at(0.0, kSwing_s, to).position - from).norm(), 1e-12);
  EXPECT_NEAR(swing.at(0.5, kSwing_s, to).position.z(), to.z() + params.height_m, 1e-12);
  const gait::PointMotion end = swing.at(1.0, kSwing_s, to);
  EXPECT_LT((end.position - swing.reach(0.0, to).position).norm(), 1e-12);
  for (double u = kStep; u < 1.0 - kStep; u += 0.01) {
    const auto before = swing.at(u - kStep, kSwing_s, to), at = swing.at(u, kSwing_s, to),
               after = swing.at(u + kStep, kSwing_s, to);
    const Eigen::Vector3d slope = (after.position - before.position) / (2.0 * kStep * kSwing_s);
    const Eigen::Vector3d curvature = (after.velocity - before.velocity) / (2.0 * kStep * kSwing_s);
    ASSERT_LT((slope - at.velocity).norm(), 1e-4) << u;
    ASSERT_LT((curvature - at.acceleration).norm(), 1e-2) << u;
  }
}

TEST(SwingTrajectory, IsOverTheFootholdAfterItsShareAndComesDownFromThere) {
  SwingTrajectory swing(SwingParams{.forward_share = 0.8});
  const Eigen::Vector3d to{0.3, 0.05, 0.07};
  swing.lift_off(Eigen::Vector3d::Zero());
  EXPECT_LT(swing.at(0.75, 0.25, to).position.x(), to.x());
  const gait::PointMotion over = swing.at(0.8, 0.25, to);
  EXPECT_LT((over.position - to).head<2>().norm(), 1e-12);
  EXPECT_GT(over.position.z(), to.z());
  EXPECT_LT(over.velocity.z(), 0.0);
}

TEST(SwingTrajectory, ReachesDownToItsDepthAndNoFurther) {
  const SwingParams params;
  const SwingTrajectory swing(params);
  const auto deepest = swing.reach(10.0, Eigen::Vector3d::Zero());
  EXPECT_DOUBLE_EQ(deepest.position.z(), -params.press_m - params.reach_depth_m);
  EXPECT_EQ(deepest.velocity.z(), 0.0);
}

TEST(LegSequencer, EndsASwingByAnEarlyContactAndStandsUntilTheNextSwing) {
  LegSequencer leg({}, kPeriod_s);
  leg.step(0.0, 0.0, 0.0);
  EXPECT_TRUE(leg.lifted_off());
  leg.step(0.3, 500.0, 0.0);  // too early to be the ground
  EXPECT_EQ(leg.action(), LegAction::kSwing);
  leg.step(0.7, 500.0, 0.0);
  EXPECT_TRUE(leg.stands());
  leg.step(0.9, 0.0, 0.0);
  EXPECT_TRUE(leg.stands());
  leg.step(-1.0, 300.0, 0.0);
  EXPECT_TRUE(leg.stands());
  leg.step(0.0, 0.0, 0.0);
  EXPECT_TRUE(leg.lifted_off());
}

TEST(LegSequencer, ReachesForTheGroundAfterASwingWithoutContact) {
  LegSequencer leg({}, kPeriod_s);
  leg.step(0.9, 0.0, 0.0);
  leg.step(-1.0, 0.0, 0.0);
  EXPECT_TRUE(leg.lost());
  leg.step(-1.0, 0.0, 0.0);
  EXPECT_EQ(leg.action(), LegAction::kReach);
  leg.step(-1.0, 100.0, 0.0);
  EXPECT_TRUE(leg.stands());
}

TEST(LegSequencer, ReachesWhenTheGroundGivesWay) {
  LegSequencer leg({}, kPeriod_s);
  leg.step(-1.0, 200.0, -3.0);
  EXPECT_TRUE(leg.lost());
}

// A swing from tick 100 to its planned touchdown at 350, which is announced at 310.
class PhaseAnnouncerTest : public testing::Test {
 protected:
  static constexpr Tick kLiftOff = 100, kTouchdown = 350, kAhead = 40, kLead = 10;

  /// Ticks at which the joints are told of a stance, as felt ones positive and as planned ones negative.
  std::vector<Tick> told(const FeltTouchdownParams& params, Tick first, Tick last, double force_N = 500.0) const {
    PhaseAnnouncer announcer(params, kPeriod_s);
    std::vector<Tick> stances;
    for (Tick tick = 0; tick < 400; ++tick) {
      const bool touches = tick >= first && tick <= last;
      std::optional<gait::PhaseSwitch> planned;
      if (tick == kLiftOff - kAhead) {
        planned = {1, kLiftOff, Phase::kSwing};
      } else if (tick == kTouchdown - kAhead) {
        planned = {2, kTouchdown, Phase::kStance};
      }
      announcer.step(tick, {.planned = planned,
                            .phase = tick >= kLiftOff && tick < kTouchdown ? Phase::kSwing : Phase::kStance,
                            .stands = touches || tick < kLiftOff || tick >= kTouchdown,
                            .normal_force_N = touches || tick < kLiftOff ? force_N : 0.0});
      if (const auto& change = announcer.announcement()) {
        EXPECT_EQ(change->count, static_cast<std::uint32_t>(stances.size()) + (change->phase == Phase::kSwing ? 1 : 2));
        if (change->phase == Phase::kStance) {
          stances.push_back(change->felt ? change->tick : -change->tick);
        }
      }
    }
    return stances;
  }

  const FeltTouchdownParams params_{
      .on = true, .force_N = 60.0, .debounce_s = 0.003, .least_swing_s = 0.05, .stance_lead_s = kLead * kPeriod_s};
};

TEST_F(PhaseAnnouncerTest, TellsAFeltTouchdownOnceAfterItsDebounceAndThenThePlan) {
  EXPECT_EQ(told(params_, 250, 400), (std::vector<Tick>{253, -kTouchdown}));
  EXPECT_EQ(told(params_, 300, 400), (std::vector<Tick>{303, -kTouchdown}));
  EXPECT_EQ(told(params_, 320, 400), (std::vector<Tick>{-kTouchdown, 323}));
}

TEST_F(PhaseAnnouncerTest, LetsThePlanGoFirstWhereBothComeAtOneTick) {
  EXPECT_EQ(told(params_, kTouchdown - kAhead - 2, 400), (std::vector<Tick>{-kTouchdown, kTouchdown - kAhead + 2}));
}

TEST_F(PhaseAnnouncerTest, FeelsNothingThatIsShortOrWeakOrComesWithTheGainsOfStance) {
  const std::vector<Tick> planned{-kTouchdown};
  EXPECT_EQ(told(params_, 250, 251), planned);
  EXPECT_EQ(told(params_, 250, 400, 59.0), planned);
  EXPECT_EQ(told(params_, kTouchdown - kLead - 3, 400), planned);
  EXPECT_EQ(told(params_, 400, 400), planned);
  FeltTouchdownParams off = params_;
  off.on = false;
  EXPECT_EQ(told(off, 250, 400), planned);
}

TEST_F(PhaseAnnouncerTest, LetsTheGainsOfSwingActAtLeastSoLong) {
  EXPECT_EQ(told(params_, kLiftOff, 400), (std::vector<Tick>{kLiftOff + 50, -kTouchdown}));
  EXPECT_EQ(told(params_, kLiftOff, kLiftOff + 45), (std::vector<Tick>{-kTouchdown}));
}

TEST(GroundPlane, FindsASlopeFromFourFeet) {
  GroundPlane plane({}, kPeriod_s);
  PerLeg<Eigen::Vector3d> feet;
  const Eigen::Matrix3d heading = rotation_by({0.0, 0.0, 0.7});
  for (int leg = 0; leg < kLegs; ++leg) {
    const Eigen::Vector3d place = heading * Eigen::Vector3d{leg < 2 ? 0.37 : -0.37, leg % 2 == 0 ? 0.3 : -0.3, 0.0};
    feet[leg] = place + Eigen::Vector3d{1.0, 2.0, 0.1 + 0.2 * place.x() - 0.1 * place.y()};
  }
  for (int tick = 0; tick < 3000; ++tick) {
    plane.update(feet, kLegs, {1.0, 2.0, 0.6}, heading);
  }
  EXPECT_NEAR(plane.height_at({1.0, 2.0, 0.0}), 0.1, 1e-6);
  EXPECT_NEAR(plane.height_at({2.0, 2.0, 0.0}), 0.3, 1e-6);
  EXPECT_LT((plane.normal() - Eigen::Vector3d{-0.2, 0.1, 1.0}.normalized()).norm(), 1e-6);
}

TEST(TrunkWrench, CarriesTheWeightAtTheReferenceAndPullsTowardsIt) {
  constexpr double kMass_kg = 80.0;
  TrunkWrenchParams params;
  params.height_integral_1_s3 = 0.0;
  params.tilt_integral_1_s = 0.0;
  TrunkWrench trunk(params, kMass_kg, kPeriod_s);
  TrunkState is, wanted;
  Wrench weight = Wrench::Zero();
  weight[2] = kMass_kg * kGravity_m_s2;
  EXPECT_LT((trunk.step(wanted, is, 1.0) - weight).norm(), 1e-9);
  wanted.position_m.z() = 0.01;
  is.rotation = rotation_by({0.01, 0.0, 0.0});
  const Wrench pulled = trunk.step(wanted, is, 1.0) - weight;
  EXPECT_NEAR(pulled[2], kMass_kg * params.position_gain_1_s2.z() * 0.01, 1e-9);
  EXPECT_NEAR(pulled[3], -params.attitude_gain_Nm_rad.x() * std::sin(0.01), 1e-9);
}

TEST(TrunkWrench, IntegralCarriesAnUnknownMassWithinItsLimit) {
  const TrunkWrenchParams params;
  TrunkWrench trunk(params, 80.0, kPeriod_s);
  TrunkState is, wanted;
  wanted.position_m.z() = 0.02;
  const double first_N = trunk.step(wanted, is, 1.0)[2];
  for (int tick = 0; tick < 100000; ++tick) {
    trunk.step(wanted, is, 1.0);
  }
  EXPECT_NEAR(trunk.step(wanted, is, 1.0)[2] - first_N, 80.0 * params.height_integral_limit_m_s2, 1.0);
}

}  // namespace planning_test
}  // namespace farrier::locomotion
