// Estimators, update logic and dither in a robot file.

#include <gtest/gtest.h>

#include "test_files.hpp"

namespace farrier::robot {
namespace adaptation_test {

/// A shipped file without a section: the lines from its title to the next blank line.
std::string without(std::string text, const std::string& title) {
  const auto at = text.find("\n" + title + ":\n");
  EXPECT_NE(at, std::string::npos) << title;
  return text.erase(at, text.find("\n\n", at) - at);
}

std::string without_all(std::string text, const std::string& line) {
  for (auto at = text.find(line); at != std::string::npos; at = text.find(line)) {
    text.erase(at, line.size());
  }
  return text;
}

/// hyq.yaml as it was before there was adaptation.
std::string without_adaptation() {
  std::string text = without(without(text_of("hyq"), "estimators"), "update_logic");
  text = without_all(text, "    estimator: rls\n");
  text = without_all(text, "  joint_estimator: valve_flow\n");
  text = without_all(text, "    dither_percent: 0.05\n");
  return without_all(text, "estimate_period_ticks: 10\n");
}

Robot loaded(const std::string& text) {
  auto robot = load_robot_text(text, "robot.yaml");
  EXPECT_TRUE(robot.ok()) << (robot ? "" : to_string(robot.error()));
  return robot ? std::move(robot).value() : Robot{};
}

std::string problems_of(const std::string& text) {
  const auto robot = load_robot_text(text, "robot.yaml");
  return robot ? "" : to_string(robot.error());
}

std::string at(const std::string& text, const std::string& what) {
  return "robot.yaml:" + std::to_string(line_of(text, what)) + ": ";
}

TEST(Adaptation, HasDefaultsWhereAFileSaysNothing) {
  const std::string text = without_adaptation();
  ASSERT_EQ(text.find("rls"), std::string::npos);
  const Robot robot = loaded(text);
  EXPECT_EQ(robot.update_logic.pole_distance_min, UpdateLogicParams{}.pole_distance_min);
  EXPECT_EQ(robot.update_logic.gain_lead_ticks, UpdateLogicParams{}.gain_lead_ticks);
  ASSERT_EQ(robot.joints.size(), 12u);
  for (const Joint& joint : robot.joints) {
    EXPECT_EQ(joint.estimator.forgetting_factor, EstimatorParams{}.forgetting_factor);
    EXPECT_EQ(joint.estimator.blank_ticks, EstimatorParams{}.blank_ticks);
    EXPECT_EQ(joint.dither_percent, 0.0) << "nobody probes a joint unasked";
    EXPECT_EQ(joint.dither_hold_ticks, 1);
  }
}

TEST(Adaptation, BlanksAsLongAsTouchdownsJitterWhereAFileSaysNothing) {
  const std::string text = replaced(without_adaptation(), "touchdown_jitter_s: 0.010", "touchdown_jitter_s: 0.030");
  const Robot robot = loaded(text);
  EXPECT_EQ(robot.joints[0].estimator.blank_ticks, 30);
  EXPECT_EQ(problems_of(print_config(robot)), "") << "what is filled in must load again";
}

TEST(Adaptation, IsTakenFromTheEstimatorAJointNames) {
  const Robot hyq = load_shipped("hyq");
  const Robot rig = load_shipped("fc1d");
  EXPECT_EQ(hyq.joints[11].estimator.forgetting_factor, 0.998);
  EXPECT_EQ(hyq.joints[11].estimator.operating_point_time_constant_s, 0.006);
  EXPECT_EQ(hyq.joints[11].estimator.operating_point_order, 2);
  EXPECT_EQ(hyq.joints[11].estimator.columns(), 4) << "velocity, force, current, bias";
  EXPECT_EQ(rig.joints[0].estimator.forgetting_factor, 0.98);
  EXPECT_EQ(rig.joints[0].estimator.columns(), 5) << "the springs need the position";
  EXPECT_EQ(hyq.joints[0].dither_percent, 0.05);
  EXPECT_EQ(hyq.update_logic.converged_ticks, 20);
}

TEST(Adaptation, TakesAFilesOwnDefaultEstimatorForJointsThatNameNone) {
  std::string text = without_all(text_of("hyq"), "    estimator: rls\n");
  text = replaced(text, "  rls:\n    forgetting_factor: 0.998", "  default:\n    forgetting_factor: 0.9");
  EXPECT_EQ(loaded(text).joints[5].estimator.forgetting_factor, 0.9);
}

TEST(Adaptation, AsksForAnEstimateOncePerPeriod) {
  const Robot robot = loaded(replaced(text_of("hyq"), "estimate_period_ticks: 10", "estimate_period_ticks: 4"));
  std::vector<Tick> due;
  for (Tick tick = 0; tick < 12; ++tick) {
    if (robot.estimate_due(tick)) {
      due.push_back(tick);
    }
  }
  EXPECT_EQ(due, (std::vector<Tick>{0, 4, 8}));
}

TEST(Adaptation, NamesTheUpdateLogicAndKeepsTheThesisOneWhereAFileDoesNot) {
  EXPECT_EQ(load_shipped("hyq").update_logic.method, UpdateMethod::kDistinctPoles);
  for (const UpdateMethod method :
       {UpdateMethod::kLimits, UpdateMethod::kSmallError, UpdateMethod::kWhiteError, UpdateMethod::kDistinctPoles}) {
    const Robot robot = loaded(replaced(text_of("hyq"), "  pole_distance_min: 0.1",
                                        std::string("  method: ") + to_string(method) + "\n  pole_distance_min: 0.1"));
    EXPECT_EQ(robot.update_logic.method, method) << to_string(method);
    EXPECT_EQ(loaded(print_config(robot)).update_logic.method, method) << to_string(method);
  }
}

struct Mistake {
  const char* from;
  const char* to;
  const char* problem;
};

void PrintTo(const Mistake& mistake, std::ostream* stream) { *stream << mistake.to; }

class AdaptationMistake : public testing::TestWithParam<Mistake> {};

TEST_P(AdaptationMistake, IsReportedWithItsLineAndRemedy) {
  const std::string text = replaced(text_of("hyq"), GetParam().from, GetParam().to);
  EXPECT_EQ(problems_of(text), at(text, GetParam().to) + GetParam().problem + "\n");
}

INSTANTIATE_TEST_SUITE_P(
    All, AdaptationMistake,
    testing::Values(
        Mistake{"blank_ticks: 22           #", "blank_ticks: 9           #",
                "estimators.rls.blank_ticks: is 9, but jitter of the touchdowns reaches into the samples: give at "
                "least 10, which is gait.touchdown_jitter_s, or more"},
        Mistake{"covariance_limit: 1e6", "covariance_limit: 4e5",
                "estimators.rls.covariance_limit: must be above the trace at the start: 4 times initial_covariance"},
        Mistake{"operating_point_time_constant_s: 0.006", "operating_point_time_constant_s: 2e-4",
                "estimators.rls.operating_point_time_constant_s: is shorter than period_s: give at least a period"},
        Mistake{"operating_point_order: 2", "operating_point_order: 5",
                "estimators.rls.operating_point_order: 5 is out of range: give 0 to 4"},
        Mistake{"innovation_forgetting: 0.9", "innovation_forgetting: 1",
                "estimators.rls.innovation_forgetting: 1 is out of range: give 0 to 0.9999"},
        Mistake{"forgetting_factor: 0.998", "forgetting_factor: 0.4",
                "estimators.rls.forgetting_factor: 0.4 is out of range: give 0.5 to 1"},
        Mistake{"converged_ticks: 20", "converged_ticks: 25",
                "update_logic.converged_ticks: 25 is not a multiple of estimate_period_ticks: give one of 10"},
        Mistake{"pole_spread_max: 0.05", "pole_spread_max: 0.11",
                "update_logic.pole_spread_max: must not be above pole_distance_min: what counts as still must not "
                "count as moved"},
        Mistake{"  pole_distance_min: 0.1", "  method: poles\n  pole_distance_min: 0.1",
                "update_logic.method: poles is not known: give limits, small_error, white_error or "
                "distinct_poles"},
        Mistake{"gain_lead_ticks: 2", "gain_lead_ticks: 1",
                "update_logic.gain_lead_ticks: 1 is out of range: give 2 to 1000"},
        Mistake{"gain_ratio_min: 1.2", "gain_ratio_min: 0.9",
                "update_logic.gain_ratio_min: 0.9 is out of range: give 1 to 1000"}));

TEST(AdaptationMistakes, IncludeAnEstimatorNobodyDeclared) {
  const std::string text = replaced(text_of("fc1d"), "    estimator: rls", "    estimator: rsl");
  EXPECT_EQ(problems_of(text), at(text, "    estimator: rsl") +
                                   "joints.piston.estimator: rsl is not one of estimators: rls, greybox, default\n");
}

TEST(AdaptationMistakes, IncludeAnEstimatePeriodThatDoesNotDivideTheDefaultConvergence) {
  const std::string text =
      replaced(without(text_of("fc1d"), "update_logic"), "estimate_period_ticks: 10", "estimate_period_ticks: 100");
  EXPECT_EQ(problems_of(text), at(text, "estimate_period_ticks: 100") +
                                   "estimate_period_ticks: 100 does not divide update_logic.converged_ticks, which "
                                   "is 20\n");
}

}  // namespace adaptation_test
}  // namespace farrier::robot
