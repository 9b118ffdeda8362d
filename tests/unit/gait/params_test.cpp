#include "gait/gait_params.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "tests/unit/gait/plan.hpp"

namespace farrier::gait {
namespace params_test {

std::string complaint(const std::function<void(RobotPlan&)>& spoil) {
  RobotPlan plan = hyq_plan();
  spoil(plan);
  const Result<Done> result = validate(plan);
  return result.ok() ? "" : result.error().message;
}

void expect_refused(const std::function<void(RobotPlan&)>& spoil, const std::string& because) {
  EXPECT_NE(complaint(spoil).find(because), std::string::npos) << complaint(spoil);
}

TEST(GaitPlan, HyQsTrotAndStandAreValid) {
  EXPECT_EQ(complaint([](RobotPlan&) {}), "");
  EXPECT_TRUE(validate(hyq_standing()).ok());
}

TEST(GaitPlan, RefusesNumbersThatAreNoGait) {
  expect_refused([](RobotPlan& plan) { plan.period_s = 0.0; }, "period");
  expect_refused([](RobotPlan& plan) { plan.gait.frequency_Hz = std::nan(""); }, "frequency");
  expect_refused([](RobotPlan& plan) { plan.gait.duty = 1.0; }, "duty");
  expect_refused([](RobotPlan& plan) { plan.gait.load_transfer_fraction = 0.6; }, "load transfer");
  expect_refused([](RobotPlan& plan) { plan.legs[1].phase_offset = 1.0; }, "rf: phase offset");
  expect_refused([](RobotPlan& plan) { plan.legs.clear(); }, "a leg");
}

TEST(GaitPlan, NamesEveryNumberItRefuses) {
  const std::string text = complaint([](RobotPlan& plan) { plan.gait.duty = -1.0, plan.gait.lead_in_s = -1.0; });
  EXPECT_NE(text.find("duty"), std::string::npos) << text;
  EXPECT_NE(text.find("lead-in"), std::string::npos) << text;
}

TEST(GaitPlan, RefusesAnAnnouncementThatAnEarlyTouchdownCouldOvertake) {
  expect_refused([](RobotPlan& plan) { plan.gait.announce_ticks = 11, plan.gait.touchdown_jitter_s = 0.010; },
                 "jitter");
  EXPECT_EQ(complaint([](RobotPlan& plan) { plan.gait.announce_ticks = 12, plan.gait.touchdown_jitter_s = 0.010; }),
            "");
}

TEST(GaitPlan, RefusesPhasesShorterThanTheAnnouncement) {
  expect_refused([](RobotPlan& plan) { plan.gait.frequency_Hz = 20.0; }, "shorter phase");
  expect_refused([](RobotPlan& plan) { plan.gait.frequency_Hz = 1000.0; }, "without a tick");
}

TEST(GaitPlan, RefusesAFootPathOutOfReach) {
  expect_refused([](RobotPlan& plan) { plan.gait.step_length_m = 1.2; }, "reach");
  expect_refused([](RobotPlan& plan) { plan.gait.hip_height_m = 0.9; }, "reach");
  expect_refused([](RobotPlan& plan) { plan.gait.step_height_m = 0.6; }, "reach");
}

TEST(GaitPlan, RefusesAHomePoseWithTheKneeBentTheOtherWay) {
  expect_refused([](RobotPlan& plan) { plan.legs[0].joints[2].home_angle_rad = 1.5; }, "home pose");
}

TEST(GaitPlan, RefusesLegKinematicsOfOneJoint) {
  expect_refused([](RobotPlan& plan) { plan.legs[3].joints.resize(1, plan.legs[3].joints[0]); }, "rh: leg kinematics");
}

TEST(GaitPlan, RefusesAMultisineItCannotSample) {
  const auto multisine = [](std::vector<double> frequencies_Hz) {
    return [frequencies_Hz](RobotPlan& plan) {
      plan.gait.reference = ReferenceKind::kMultisine;
      plan.gait.multisine_frequencies_Hz = frequencies_Hz;
    };
  };
  expect_refused(multisine({}), "needs a frequency");
  expect_refused(multisine({2.0, 500.0}), "half the sampling rate");
  EXPECT_EQ(complaint(multisine({2.0, 5.0, 10.0})), "");
}

}  // namespace params_test
}  // namespace farrier::gait
