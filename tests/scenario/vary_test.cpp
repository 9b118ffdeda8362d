// Robots nobody believes in: what is drawn, and runs over them.

#include <algorithm>
#include <cmath>

#include "gait/reference.hpp"
#include "gait/schedule.hpp"
#include "trials/grey_box.hpp"
#include "trials/vary.hpp"
#include "tests/scenario/scenario_run.hpp"
#include "report/trot/tracking.hpp"

namespace farrier::scenario {
namespace vary_test {

constexpr Tick kTicks = 4000;  // every leg's third stride, from which a run is judged, is over here
constexpr std::uint64_t kSeeds = 200;

bool within(double value, const robot::Interval& range) { return value >= range.low && value <= range.high; }

// The smallest of kSeeds uniform draws lies in the lowest tenth but for one chance in 10^9.
bool fills(std::vector<double> values, const robot::Interval& range) {
  const auto [low, high] = std::ranges::minmax(values);
  const double tenth = 0.1 * (range.high - range.low);
  return low < range.low + tenth && high > range.high - tenth;
}

TEST(Variation, DrawsFromTheWholeOfItsRanges) {
  const robot::Robot hyq = load("hyq");
  const robot::Variation& ranges = hyq.variation;
  std::vector<double> supply, friction, valve, mass;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const trials::Draw draw = trials::draw_variation(hyq, seed);
    const trials::JointDraw& knee = draw.joints[hyq.find("lf_kfe")->number];
    supply.push_back(draw.supply_factor);
    friction.push_back(knee.friction_factor);
    valve.push_back(knee.valve_factor);
    mass.push_back(knee.stance_mass);
    ASSERT_TRUE(within(supply.back(), ranges.supply_factor) && within(friction.back(), ranges.friction_factor) &&
                within(valve.back(), ranges.valve_gain_factor) && within(mass.back(), ranges.stance_mass_kg));
  }
  EXPECT_TRUE(fills(supply, ranges.supply_factor));
  EXPECT_TRUE(fills(friction, ranges.friction_factor));
  EXPECT_TRUE(fills(valve, ranges.valve_gain_factor));
  EXPECT_TRUE(fills(mass, ranges.stance_mass_kg));
}

TEST(Variation, WithAnEndGivenTwiceDrawsThatValue) {
  robot::Robot hyq = load("hyq");
  hyq.variation.supply_factor = {0.8, 0.8};
  hyq.variation.stance_mass_kg = {42.0, 42.0};
  const trials::Draw draw = trials::draw_variation(hyq, 4);
  EXPECT_EQ(draw.supply_factor, 0.8);
  EXPECT_EQ(draw.joints[hyq.find("rh_kfe")->number].stance_mass, 42.0);
}

TEST(Variation, HasTheBodyOfItsRobotFile) {
  const robot::Robot hyq = load("hyq");
  const robot::Robot lighter = trials::with_varied_body(hyq);
  EXPECT_EQ(lighter.plan.body_weight_N, 75.0 * 9.81);
  const trials::Draw draw = trials::draw_variation(lighter, 4);
  EXPECT_EQ(trials::varied(lighter, draw).plan.body_weight_N, lighter.plan.body_weight_N) << "world and beliefs alike";
  robot::Robot unsaid = hyq;
  unsaid.variation.body_mass_kg = 0.0;
  EXPECT_EQ(trials::with_varied_body(unsaid).plan.body_weight_N, hyq.plan.body_weight_N);
  EXPECT_EQ(trials::with_varied_body(load("fc1d")).plan.body_weight_N, 0.0);
}

// Ratio of the force that the reference asks of a joint in stance to the smallest that its cylinder gives at rest in
// any draw, p_s A_r for pull and p_s A_p for push. Below one, every draw can be carried.
TEST(Variation, AsksNoCylinderForMoreThanTheLeastSupplyGives) {
  const auto largest_demand = [](const robot::Robot& robot) {
    const gait::Reference reference(robot.plan);
    const gait::Schedule schedule(robot.plan, 1);
    double largest = 0.0;
    for (const robot::Joint& joint : robot.joints) {
      const double low_Pa = robot.variation.supply_factor.low * joint.actuator.supply_pressure_Pa;
      for (Tick tick = kTicks - schedule.stride_ticks(); tick < kTicks; ++tick) {
        const gait::JointReference asked = reference.at(joint.leg, joint.index_in_leg, tick);
        const double force = joint.linkage.force(asked.position_rad, asked.torque_ff_Nm);
        const double area = force > 0.0 ? joint.actuator.area_a : joint.actuator.area_b;
        if (schedule.phase(joint.leg, tick) == gait::Phase::kStance) {
          largest = std::max(largest, std::abs(force) / (low_Pa * area));
        }
      }
    }
    return largest;
  };
  const robot::Robot hyq = load("hyq");
  EXPECT_GT(largest_demand(hyq), 1.0) << "84.8 kg, which is why varied robots are lighter";
  EXPECT_LT(largest_demand(trials::with_varied_body(hyq)), 1.0);
}

TEST(Variation, OfAJointDoesNotDependOnTheOthersOrTheirOrder) {
  const robot::Robot hyq = load("hyq");
  robot::Robot turned = hyq;
  std::ranges::reverse(turned.joints);
  turned.joints.erase(turned.joints.begin() + 5, turned.joints.end());
  const trials::Draw all = trials::draw_variation(hyq, 4);
  const trials::Draw few = trials::draw_variation(turned, 4);
  EXPECT_EQ(all.supply_factor, few.supply_factor);
  for (std::size_t i = 0; i < turned.joints.size(); ++i) {
    const trials::JointDraw& there = all.joints[turned.joints[i].number];
    EXPECT_EQ(few.joints[i].friction_factor, there.friction_factor);
    EXPECT_EQ(few.joints[i].valve_factor, there.valve_factor);
    EXPECT_EQ(few.joints[i].stance_mass, there.stance_mass);
  }
}

TEST(Variation, ChangesTheWorldAndNothingThatIsBelieved) {
  const robot::Robot hyq = load("hyq");
  const trials::Draw draw = trials::draw_variation(hyq, 4);
  const robot::Robot world = trials::varied(hyq, draw);
  for (const robot::Joint& joint : hyq.joints) {
    const robot::Joint& there = world.joints[joint.number];
    const trials::JointDraw& drawn = draw.joints[joint.number];
    EXPECT_EQ(there.actuator.supply_pressure_Pa, draw.supply_factor * joint.actuator.supply_pressure_Pa);
    EXPECT_EQ(there.actuator.valve_gain, drawn.valve_factor * joint.actuator.valve_gain);
    EXPECT_EQ(there.swing_load.damping, drawn.friction_factor * joint.swing_load.damping);
    EXPECT_EQ(there.stance_load.damping, drawn.friction_factor * joint.stance_load.damping);
    EXPECT_EQ(there.swing_load.mass, joint.swing_load.mass);
    const bool hip = joint.index_in_leg == 0;
    EXPECT_EQ(there.stance_load.mass == joint.stance_load.mass, hip) << joint.name;
    EXPECT_EQ(there.push_limit, joint.push_limit);
    EXPECT_EQ(there.normalisation.current_A, joint.normalisation.current_A);
    const auto& planned = world.plan.legs[static_cast<std::size_t>(joint.leg)].joints;
    EXPECT_EQ(planned[static_cast<std::size_t>(joint.index_in_leg)].stance_load.mass, joint.stance_load.mass);
  }
}

TEST(InprocRun, GivesItsSinkTheRowsOfItsTrace) {
  const robot::Robot hyq = load("hyq");
  std::vector<trace::TraceRow> rows;
  run::InprocRun settings;
  settings.ticks = 200;
  settings.sink = [&](const trace::TraceRow& row) { rows.push_back(row); };
  const Outcome outcome = run(hyq, settings);
  ASSERT_EQ(rows.size(), outcome.rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].tick, outcome.rows[i].tick);
    ASSERT_EQ(rows[i].joint, outcome.rows[i].joint);
    ASSERT_EQ(rows[i].force_N_or_Nm, outcome.rows[i].force_N_or_Nm);
    ASSERT_EQ(rows[i].valve_current_A, outcome.rows[i].valve_current_A);
    ASSERT_EQ(rows[i].faults, outcome.rows[i].faults);
  }
}

TEST(InprocRun, SimulatesAWorldTheNodesDoNotKnow) {
  const robot::Robot hyq = load("hyq");
  const robot::Robot world = trials::varied(hyq, trials::draw_variation(hyq, 1));
  run::InprocRun settings;
  settings.ticks = 600;
  settings.simulated = &world;
  const Outcome outcome = run(hyq, settings);
  const robot::Joint& knee = *world.find("lf_kfe");
  EXPECT_EQ(outcome.at(0, knee.number, hyq.joints.size()).load_mass_kg_or_kgm2, knee.stance_load.mass);
}

TEST(InprocRun, SwitchesExactlyAtTouchdownWhenToldWhatWillHappen) {
  const robot::Robot hyq = load_with_jitter("hyq", 0.010);
  for (const locomotion::Announce announce : {locomotion::Announce::kPlanned, locomotion::Announce::kActual}) {
    run::InprocRun settings;
    settings.ticks = kTicks;
    settings.announce = announce;
    int apart = 0;
    for (const trace::TraceRow& row : run(hyq, settings).rows) {
      apart += row.phase != row.actual_phase ? 1 : 0;
    }
    EXPECT_EQ(apart == 0, announce == locomotion::Announce::kActual) << apart;
  }
}

// The thesis (9.2.5) found both controllers alike on a known system; this one knows no phases and needs none.
TEST(Trot, TracksTorqueInStanceAndSwingByTheNominalFlowLaw) {
  robot::Robot hyq = load("hyq");
  for (robot::Joint& joint : hyq.joints) {
    joint.kind = control::Kind::kFeedbackLinearisation;
    joint.dither_percent = 0.0;  // only adaptation asks for it
  }
  run::InprocRun settings;
  settings.ticks = kTicks;
  const report::Tracking tracking =
      report::track(hyq, gait::Schedule(hyq.plan, settings.seed), run(hyq, settings).rows, 0);
  for (const robot::Joint& joint : hyq.joints) {
    const report::JointTracking& of_joint = tracking.joints.at(joint.number);
    EXPECT_LE(of_joint.stance.nrmse, hyq.bounds.stance_nrmse) << joint.name;
    EXPECT_LE(of_joint.swing.nrmse, hyq.bounds.stance_nrmse) << joint.name;
    EXPECT_EQ(of_joint.not_tracking_ticks, 0u) << joint.name;
  }
}

/// Stance NRMSE of every joint of two varied robots, whose nodes are `believed`.
std::vector<double> stance_errors_of_two_seeds(const robot::Robot& believed, supervisor::Design design) {
  std::vector<double> errors;
  for (const std::uint64_t seed : {1u, 2u}) {
    const robot::Robot world = trials::varied(believed, trials::draw_variation(believed, seed));
    run::InprocRun settings;
    settings.grouping = run::Grouping::kOne;
    settings.ticks = kTicks;
    settings.seed = seed;
    settings.design = design;
    settings.simulated = &world;
    const report::Tracking tracking =
        report::track(believed, gait::Schedule(believed.plan, seed), run(believed, settings).rows, 0);
    for (const report::JointTracking& joint : tracking.joints) {
      EXPECT_EQ(joint.not_tracking_ticks, 0u);
      errors.push_back(joint.stance.nrmse);
    }
  }
  std::ranges::sort(errors);
  return errors;
}

// The judgement of farrier compare controllers, on two robots.
TEST(Controllers, TheGreyBoxWithFlowInversionIsAtMostFivePercentWorseThanTheNominalFlowLawAndNeverFails) {
  constexpr double kRatioAtMost = 1.05;
  constexpr double kFailed = 0.3;
  const robot::Robot hyq = trials::with_varied_body(load("hyq"));
  robot::Robot nominal = hyq;
  for (robot::Joint& joint : nominal.joints) {
    joint.kind = control::Kind::kFeedbackLinearisation;
    joint.dither_percent = 0.0;
  }
  const auto grey = stance_errors_of_two_seeds(trials::with_grey_box(hyq), supervisor::Design::kAdaptive);
  const auto flow_law = stance_errors_of_two_seeds(nominal, supervisor::Design::kStance);
  EXPECT_LE(grey[grey.size() / 2], kRatioAtMost * flow_law[flow_law.size() / 2]);
  EXPECT_LT(grey.back(), kFailed);
}

}  // namespace vary_test
}  // namespace farrier::scenario
