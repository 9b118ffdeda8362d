// Results of searches for hidden effects.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "report/diagnosis/hide_result.hpp"

namespace farrier::report {
namespace hide_test {

/// A deadband hidden in the knee; what the hip's and the knee's recordings said.
HideTrial trial(JointVerdict hip, JointVerdict knee) {
  HideTrial trial{.seed = 3,
                  .joint = "knee",
                  .effect = "valve_deadband",
                  .parameter = "half_width_A",
                  .unit = "A",
                  .value = 0.0005,
                  .verdicts = {std::move(hip), std::move(knee)},
                  .nrmse_nominal = 0.02,
                  .nrmse_hidden = 0.06,
                  .nrmse_known = 0.03};
  return trial;
}

const JointVerdict kSilentHip{.joint = "hip", .verdict = "none", .effects = {}, .tied = {}, .gain = 0.0};
const JointVerdict kKnee{
    .joint = "knee", .verdict = "effects", .effects = {"valve_deadband", "valve_bias"}, .tied = {}, .gain = 0.7};

JointVerdict knee(const char* verdict, std::vector<std::string> effects, std::vector<std::string> tied = {}) {
  return {.joint = "knee", .verdict = verdict, .effects = std::move(effects), .tied = std::move(tied), .gain = 0.7};
}

TEST(HideResult, NamesByTheFirstEffectOfTheJointWithTheLargestGain) {
  EXPECT_TRUE(trial(kSilentHip, kKnee).named());
  EXPECT_FALSE(trial(kSilentHip, knee("effects", {"valve_bias", "valve_deadband"})).named());
  EXPECT_FALSE(trial(kSilentHip, knee("unknown", {})).named());
  JointVerdict loud_hip{.joint = "hip", .verdict = "effects", .effects = {"valve_deadband"}, .tied = {}, .gain = 0.8};
  EXPECT_FALSE(trial(loud_hip, kKnee).named());
  loud_hip.gain = 0.6;
  EXPECT_TRUE(trial(loud_hip, kKnee).named());
  EXPECT_EQ(trial(loud_hip, kKnee).false_joints(), 1u);
}

TEST(HideResult, SuspectsNoJointThatIsGoodOrCannotBeJudged) {
  for (const char* verdict : {"none", "not_excited", "bad_data"}) {
    const HideTrial of = trial(kSilentHip, knee(verdict, {}));
    EXPECT_EQ(of.suspect(), nullptr) << verdict;
    EXPECT_FALSE(of.named());
    EXPECT_FALSE(of.named_or_tied());
    EXPECT_EQ(of.false_joints(), 0u);
  }
}

TEST(HideResult, CountsATieApart) {
  const HideTrial tied = trial(kSilentHip, knee("cannot_separate", {"valve_bias"}, {"valve_deadband"}));
  EXPECT_FALSE(tied.named());
  EXPECT_TRUE(tied.named_or_tied());
}

TEST(HideResult, AsksForElevenOfTwelve) {
  EXPECT_EQ(least_named(1), 1.0);
  EXPECT_EQ(least_named(2), 2.0);
  EXPECT_EQ(least_named(12), 11.0);
  EXPECT_EQ(least_named(24), 22.0);
}

TEST(HideResult, AFoundModelMustBringBackHalfOfTheTracking) {
  std::vector<HideTrial> trials(12, trial(kSilentHip, kKnee));  // 0.02, 0.06 with the effect, 0.03 with the model
  Figures good;
  add_hide(good, trials);
  EXPECT_NEAR(*good.find("hide.nrmse_known")->bound, 0.04, 1e-12);
  EXPECT_TRUE(good.all_hold());
  for (HideTrial& each : trials) {
    each.nrmse_known = 0.05;
  }
  Figures bad;
  add_hide(bad, trials);
  EXPECT_FALSE(bad.all_hold());
  trials.resize(11);
  Figures few;
  add_hide(few, trials);
  EXPECT_FALSE(few.find("hide.nrmse_known")->bound.has_value());
}

TEST(HideResult, AllowsOneSuspectedJointInTwelveTrials) {
  EXPECT_EQ(most_false_joints(1), 0.0);
  EXPECT_EQ(most_false_joints(12), 1.0);
  EXPECT_EQ(most_false_joints(24), 2.0);
}

TEST(HideResult, GivesFiguresOverTheSeeds) {
  std::vector<HideTrial> trials(12, trial(kSilentHip, kKnee));
  trials[4].verdicts[1].verdict = "unknown";
  trials[4].verdicts[1].effects.clear();
  trials[5].nrmse_known = 0.03 + 12 * 0.01;
  Figures figures;
  add_hide(figures, trials);
  EXPECT_EQ(figures.find("hide.named")->value, 11.0);
  EXPECT_TRUE(figures.find("hide.named")->holds());
  EXPECT_NEAR(figures.find("hide.nrmse_known")->value, 0.04, 1e-12);
  EXPECT_NEAR(figures.find("hide.nrmse_hidden")->value, 0.06, 1e-12);
  trials[6].verdicts[1] = knee("effects", {"valve_bias"});
  Figures worse;
  add_hide(worse, trials);
  EXPECT_FALSE(worse.find("hide.named")->holds());
}

TEST(HideResult, SaysLastWhatWasHidden) {
  const HideTrial one = trial(kSilentHip, kKnee);
  const std::string text = hide_text(std::span(&one, 1));
  const std::string last = "hidden: knee valve_deadband half_width_A = 0.0005 A, seed 3\n";
  EXPECT_TRUE(text.ends_with(last)) << text;
  EXPECT_NE(text.find("effects: valve_deadband, valve_bias  <--"), std::string::npos) << text;
  const std::vector<HideTrial> two(2, one);
  EXPECT_NE(hide_text(two).find("named: knee, effects"), std::string::npos) << hide_text(two);
}

TEST(HideResult, WritesARowForEveryJointAndSeed) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("farrier_hide_" + std::to_string(::getpid()) + ".csv")).string();
  const std::vector<HideTrial> trials(2, trial(kSilentHip, kKnee));
  ASSERT_TRUE(write_hide_csv(path, trials).ok());
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  const std::string rows = text.str();
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 5);
  EXPECT_NE(rows.find("3,knee,valve_deadband,0.0005,A,0.02,0.06,0.03,knee,effects,valve_deadband valve_bias,,0.7,1\n"),
            std::string::npos)
      << rows;
  std::filesystem::remove(path);
  EXPECT_FALSE(write_hide_csv("/nowhere/hide.csv", trials).ok());
}

}  // namespace hide_test
}  // namespace farrier::report
