// Method and gate of an estimator in a robot file, and the estimator that they make.

#include <gtest/gtest.h>

#include "robot/make_estimator.hpp"
#include "test_files.hpp"

namespace farrier::robot {
namespace estimator_test {

using estimation::EstimationMethod;
using estimation::GateKind;

constexpr const char* kFirstLine = "    forgetting_factor: 0.998  # half a second: a stance and a swing\n";

/// hyq.yaml whose estimator begins with `lines` in place of its forgetting factor.
std::string with(const std::string& lines) { return replaced(text_of("hyq"), kFirstLine, lines); }

std::string problems_of(const std::string& text) {
  const auto robot = load_robot_text(text, "robot.yaml");
  return robot ? "" : to_string(robot.error());
}

/// Default parameters of a method.
EstimatorParams params_of(EstimationMethod method) {
  EstimatorParams params;
  params.method = method;
  return params;
}

/// Without the parameters that only some methods have.
std::string method(const std::string& name, const std::string& more = "") {
  std::string text = with("    method: " + name + "\n" + more);
  const auto kind = parse_choice("method", estimation::kEstimationMethods, name);
  if (kind && !params_of(kind.value()).limits_covariance() && name != "greybox") {
    text = replaced(text, "    covariance_limit: 1e6\n", "");
  }
  if (name == "greybox") {
    const std::size_t first = text.find("    bias: true\n    position:");
    const std::size_t after = text.find("    blank_ticks:", first);
    text.erase(first, after - first);
  }
  return text;
}

TEST(EstimatorMethod, IsLeastSquaresWithoutAGateWhereAFileSaysNothing) {
  const Robot hyq = load_shipped("hyq");
  EXPECT_EQ(hyq.joints[3].estimator.method, EstimationMethod::kRls);
  EXPECT_EQ(hyq.joints[3].estimator.gate, GateKind::kNone);
}

TEST(EstimatorMethod, IsMadeByItsNameAndPrintsAndLoadsAgain) {
  for (const auto& [name, kind] : estimation::kEstimationMethods) {
    if (!params_of(kind).regresses()) {
      continue;  // greybox has no gates, and a test of its own
    }
    for (const std::string gate : {"none", "pe", "fft"}) {
      const std::string text = method(name, "    gate: " + gate + "\n");
      ASSERT_EQ(problems_of(text), "") << name << " " << gate;
      const Robot robot = load_robot_text(text, "robot.yaml").value();
      EXPECT_EQ(robot.joints[0].estimator.method, kind);
      const auto made = make_estimator(robot.joints[0], robot.period_s, 1);
      ASSERT_TRUE(made.ok()) << made.error().message;
      EXPECT_EQ(made.value()->estimate().samples, 0u);
      const std::string printed = print_config(robot);
      const auto again = load_robot_text(printed, "printed.yaml");
      ASSERT_TRUE(again.ok()) << to_string(again.error());
      EXPECT_EQ(print_config(again.value()), printed);
    }
  }
}

TEST(EstimatorMethod, GreyBoxHasItsOwnParametersAndNoneOfARegression) {
  const std::string text = method("greybox", "    grey_box: {flow_error: 0.05, bias_drift: 0.1}\n");
  ASSERT_EQ(problems_of(text), "");
  const Robot robot = load_robot_text(text, "robot.yaml").value();
  ASSERT_TRUE(robot.joints[0].estimator.grey_box.has_value());
  EXPECT_EQ(robot.joints[0].estimator.grey_box->flow_error, 0.05);
  const auto made = make_estimator(robot.joints[0], robot.period_s, 1);
  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_TRUE(made.value()->estimate().has_physics);
  EXPECT_NE(problems_of(method("greybox", "    initial_covariance: 1e5\n")).find("initial_covariance"),
            std::string::npos);
  EXPECT_NE(problems_of(method("greybox", "    gate: pe\n")).find("gate: none"), std::string::npos);
  EXPECT_NE(problems_of(method("rls", "    grey_box: {flow_error: 0.05}\n")).find("method: greybox"),
            std::string::npos);
}

TEST(EstimatorMethod, TakesItsOwnParameters) {
  const Robot robot = load_robot_text(method("aff",
                                             "    aff: {forgetting_min: 0.7, noise_factor: 9}\n    gate: pe\n"
                                             "    pe: {window_ticks: 50}\n"),
                                      "robot.yaml")
                          .value();
  EXPECT_EQ(robot.joints[0].estimator.aff.value().forgetting_min, 0.7);
  EXPECT_EQ(robot.joints[0].estimator.aff.value().noise_factor, 9.0);
  EXPECT_EQ(robot.joints[0].estimator.aff.value().error_memory, estimation::AdaptiveForgettingParams{}.error_memory);
  EXPECT_EQ(robot.joints[0].estimator.pe.value().window_ticks, 50);
  const Robot plain = load_robot_text(method("sift"), "robot.yaml").value();
  EXPECT_EQ(plain.joints[0].estimator.sift.value().excitation_min, estimation::SubspaceParams{}.excitation_min);
}

TEST(EstimatorMethod, RefusesWhatItsChoiceDoesNotUseWithPlaceAndRemedy) {
  const auto expect = [](const std::string& text, const std::string& line, const std::string& problem) {
    EXPECT_EQ(problems_of(text),
              "robot.yaml:" + std::to_string(line_of(text, line)) + ": estimators.rls." + problem + "\n");
  };
  expect(method("rls", "    aff: {noise_factor: 9}\n"),
         "    aff:", "aff: is not used: give method: aff, or leave aff out");
  expect(method("aff", "    sift: {excitation_min: 9}\n"),
         "    sift:", "sift: is not used: give method: sift, or leave sift out");
  expect(method("aff", "    gate: fft\n    pe: {window_ticks: 9}\n"),
         "    pe:", "pe: is not used: give gate: pe, or leave pe out");
  expect(method("rls", "    gate: fft\n    fft: {window_ticks: 63}\n"), "    fft:", "fft.window_ticks: must be even");
  const std::string unused = problems_of(with("    method: kalman\n    forgetting_factor: 0.9\n"));
  EXPECT_NE(unused.find("estimators.rls.forgetting_factor: is not a known parameter"), std::string::npos) << unused;
  const std::string bounded = problems_of(with("    method: sift\n"));
  EXPECT_NE(bounded.find("estimators.rls.covariance_limit: is not a known parameter"), std::string::npos) << bounded;
  const std::string nobody = problems_of(with("    method: guess\n"));
  EXPECT_NE(nobody.find("estimators.rls.method: "), std::string::npos) << nobody;
}

TEST(MakeEstimator, RefusesAJointItCannotServeNamingTheCondition) {
  Joint spring = load_shipped("fc1d").joints[0];
  ASSERT_GT(spring.swing_load.stiffness, 0.0);
  EXPECT_TRUE(make_estimator(spring, 0.001, 0).ok());
  spring.estimator.position = false;
  const auto blind = make_estimator(spring, 0.001, 0);
  ASSERT_FALSE(blind.ok());
  EXPECT_NE(blind.error().message.find(spring.name + ": its load has a spring"), std::string::npos);
  EXPECT_NE(blind.error().message.find("give position: true"), std::string::npos);
  Joint joint = load_shipped("hyq").joints[0];
  joint.estimator.method = EstimationMethod::kSift;
  joint.estimator.sift = estimation::SubspaceParams{.excitation_min = -1.0};
  const auto refused = make_estimator(joint, 0.001, 0);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find(joint.name + ": sift.excitation_min"), std::string::npos);
  EXPECT_FALSE(make_estimator(load_shipped("hyq").joints[0], 0.001, 3).ok()) << "a delay beyond what is remembered";
}

}  // namespace estimator_test
}  // namespace farrier::robot
