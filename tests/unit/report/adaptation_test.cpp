#include <fstream>
#include <sstream>

#include <nlohmann/json.hpp>

#include "control/numerics/spectrum.hpp"
#include "run.hpp"
#include "robot/joint_model.hpp"
#include "supervisor/joint_design.hpp"
#include "supervisor/supervisor.hpp"
#include "report/trot/adaptation.hpp"
#include "report/figures/console.hpp"
#include "report/trot/html_report.hpp"

namespace farrier::report {
namespace adaptation_test {

using signals::JointUpdateDecision;
using signals::UpdateVerdict;
using testing::hyq;

constexpr Tick kJudged = 9000;
constexpr Tick kShort = 8999;

JointUpdateDecision decision(const robot::Joint& joint, Tick tick, UpdateVerdict verdict = UpdateVerdict::kAccepted) {
  JointUpdateDecision decision;
  decision.joint = joint.number;
  decision.tick = tick;
  decision.phase = signals::Phase::kStance;
  decision.verdict = verdict;
  decision.generation = 3;
  return decision;
}

/// Each of the joints `times` over.
std::vector<DecisionInfo> updates_of(const robot::Robot& robot, int times) {
  std::vector<JointUpdateDecision> decisions;
  for (int i = 0; i < times; ++i) {
    for (const robot::Joint& joint : robot.joints) {
      decisions.push_back(decision(joint, 1000 * (i + 1)));
    }
  }
  return decision_infos(robot, decisions);
}

std::size_t bounded(const Figures& figures) {
  return static_cast<std::size_t>(
      std::ranges::count_if(figures.all(), [](const Figure& figure) { return figure.bound.has_value(); }));
}

TEST(Updates, AreCountedByJointAndVerdict) {
  const robot::Robot robot = hyq();
  const robot::Joint& knee = robot.joints[2];
  const auto decisions =
      decision_infos(robot, std::vector{decision(knee, 500), decision(knee, 900, UpdateVerdict::kUnstableOnEstimate),
                                        decision(robot.joints[4], 950)});
  Figures figures;
  add_updates(figures, robot, decisions, kJudged, false);
  EXPECT_EQ(figures.find("trot." + knee.name + ".updates")->value, 1.0);
  EXPECT_EQ(figures.find("trot." + knee.name + ".refused_designs")->value, 1.0);
  EXPECT_EQ(figures.find("trot.lf_haa.updates")->value, 0.0);
  EXPECT_EQ(figures.find("trot.updates")->value, 2.0);
  EXPECT_EQ(bounded(figures), 0u);
}

TEST(Updates, OfHipsAndKneesAreBoundedInAnAdaptiveRunThatIsLongEnough) {
  const robot::Robot robot = hyq();
  for (const auto& [times, holds] : {std::pair(2, false), std::pair(3, true)}) {
    Figures figures;
    add_updates(figures, robot, updates_of(robot, times), kJudged, true);
    EXPECT_EQ(bounded(figures), 8u);
    EXPECT_FALSE(figures.find("trot.rh_haa.updates")->bound.has_value());
    EXPECT_EQ(figures.all_hold(), holds) << times;
  }
  Figures figures;
  add_updates(figures, robot, {}, kShort, true);
  EXPECT_EQ(bounded(figures), 0u);
}

TEST(Updates, OfARobotThatStandsOrHasNoHipsAndKneesAreNotBounded) {
  const auto rig = robot::load_robot(std::string(FARRIER_ROBOTS) + "/fc1d.yaml");
  ASSERT_TRUE(rig.ok());
  for (const robot::Robot& robot :
       {rig.value(), hyq({.pattern = gait::Pattern::kStand, .frequency_Hz = std::nullopt})}) {
    Figures figures;
    add_updates(figures, robot, {}, kJudged, true);
    EXPECT_EQ(bounded(figures), 0u) << robot.name;
  }
}

TEST(Decisions, OfJointsTheRobotDoesNotHaveAreLeftOut) {
  const robot::Robot robot = hyq();
  JointUpdateDecision stranger = decision(robot.joints[0], 500);
  stranger.joint = 99;
  EXPECT_TRUE(decision_infos(robot, std::vector{stranger}).empty());
}

TEST(Decisions, AreInTheJsonAndTheConsoleCountsThem) {
  const robot::Robot robot = hyq();
  Outcome outcome{.command = "trot", .figures = {}, .run = run_info(robot, 1), .failures = {}, .warnings = {"odd"}};
  JointUpdateDecision update = decision(robot.joints[1], 812);
  update.pole_distance = 0.25;
  update.disk_margin = 0.5;
  update.delay_margin_s = 0.002;
  update.dwell_ticks = 12;
  update.prediction_error = 1.5;
  update.whiteness = 0.75;
  update.poles_re = {0.9, 0.5, 0.5};
  update.poles_im = {0.0, 0.1, -0.1};
  outcome.run.decisions = decision_infos(robot, std::vector{update});
  outcome.figures.add("trot.lf_hfe.stance_nrmse", 0.05, 0.1);
  outcome.figures.add("trot.lf_hfe.updates", 7.0, 3.0);
  const auto json = nlohmann::json::parse(to_json(outcome));
  EXPECT_EQ(json["warnings"], nlohmann::json::parse(R"(["odd"])"));
  const auto& listed = json["run"]["decisions"][0];
  EXPECT_EQ(listed["tick"], 812);
  EXPECT_EQ(listed["joint"], "lf_hfe");
  EXPECT_EQ(listed["phase"], "stance");
  EXPECT_EQ(listed["verdict"], signals::to_string(UpdateVerdict::kAccepted));
  EXPECT_EQ(listed["pole_distance"], 0.25);
  EXPECT_EQ(listed["disk_margin"], 0.5);
  EXPECT_EQ(listed["delay_margin_s"], 0.002);
  EXPECT_EQ(listed["dwell_ticks"], 12);
  EXPECT_EQ(listed["prediction_error"], 1.5);
  EXPECT_EQ(listed["whiteness"], 0.75);
  EXPECT_EQ(listed["poles"], nlohmann::json::parse("[[0.9, 0.0], [0.5, 0.1], [0.5, -0.1]]"));
  const std::string text = console_text(outcome, false);
  EXPECT_NE(text.find("joint   updates  stance NRMSE"), std::string::npos) << text;
  EXPECT_NE(text.find("warning: odd"), std::string::npos) << text;
  EXPECT_EQ(text.find("trot.lf_hfe.updates"), std::string::npos) << text;
}

class AdaptivePage : public testing::OwnFolder {};

TEST_F(AdaptivePage, ShowsGainsAndEstimatesOfTheJointsThatWereDecidedOn) {
  const robot::Robot robot = hyq();
  const gait::Schedule schedule{robot.plan, testing::kSeed};
  const robot::Joint& knee = robot.joints[2];
  const auto rows = testing::rows_of(robot, schedule, 3000, testing::lagging_forces(robot, schedule));
  const auto model = robot::model_of(knee, knee.stance_load, robot.period_s);
  const auto poles = control::eigenvalues(model.a);
  JointUpdateDecision update = decision(knee, 812);
  for (std::size_t i = 0; i < 3; ++i) {
    update.poles_re[i] = poles[static_cast<Eigen::Index>(i)].real();
    update.poles_im[i] = poles[static_cast<Eigen::Index>(i)].imag();
  }
  auto supervisor = supervisor::Supervisor::create(robot, supervisor::Design::kAdaptive, 0, 1);
  ASSERT_TRUE(supervisor.ok());
  const std::vector<signals::JointControllerGains> gains = supervisor.value().step(0).gains;
  Outcome outcome{.command = "trot", .figures = {}, .run = run_info(robot, 1), .failures = {}};
  outcome.run.decisions = decision_infos(robot, std::vector{update});
  const auto page = write_report(path_, {outcome, robot, schedule, rows, 0, gains});
  ASSERT_TRUE(page.ok()) << page.error().message;
  std::ostringstream html;
  html << std::ifstream(page.value()).rdbuf();
  EXPECT_NE(html.str().find("pictures/lf_kfe_adaptation.svg"), std::string::npos);
  EXPECT_NE(html.str().find("All of them: 1<"), std::string::npos);
  EXPECT_EQ(html.str().find("pictures/lf_hfe_adaptation.svg"), std::string::npos);
  for (const char* name : {"pictures/lf_kfe_adaptation.svg", "pictures/lf_kfe_estimates.svg"}) {
    EXPECT_NE(html.str().find(name), std::string::npos) << name;
    std::ostringstream picture;
    picture << std::ifstream(path_ + "/" + name).rdbuf();
    EXPECT_NE(picture.str().find("</svg>"), std::string::npos) << name;
  }
}

}  // namespace adaptation_test
}  // namespace farrier::report
