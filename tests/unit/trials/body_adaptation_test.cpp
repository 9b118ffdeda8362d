#include <gtest/gtest.h>

#include <algorithm>

#include "trials/body/adaptation_study.hpp"
#include "trials/body/compared_runs.hpp"
#include "trials/body/fixed_search.hpp"
#include "world/scene_file.hpp"

namespace farrier::trials {
namespace body_adaptation_test {

// Estimates of a coupled body are judged by the update logic, and those that are not valid become no gains.
TEST(BodyAdaptation, TakesNoGainsFromAnEstimateThatIsNotValid) {
  robot::Robot hyq = robot::load_robot(FARRIER_ROBOTS "hyq.yaml", {.on_ground = true}).value();
  for (robot::Joint& joint : hyq.joints) {
    joint.kind = control::Kind::kLqr;
  }
  TrotCase one = compared_cases(hyq, 1).front();
  one.judged_until_s = one.end_s = one.trot_s + 3.0;
  one.adapts = true;
  const TrotFigures figures = run_trot_case(hyq, one, Joints::kActuators).value().value();
  EXPECT_FALSE(figures.fell_s.has_value()) << *figures.fell_s;
  const AdaptationCounts counts = figures.adaptation.value();
  EXPECT_EQ(counts.estimates, 12 * static_cast<int>(one.end_s / hyq.period_s) / hyq.estimate_period_ticks);
  EXPECT_LT(counts.valid, counts.estimates / 2);
  EXPECT_EQ(counts.invalid_updates, 0);
  EXPECT_EQ(counts.gains_refused, 0);
}

// One of two coils of every valve is lost in mid-run, at 1.0 m/s. The design with fixed gains falls.
TEST(BodyAdaptation, WalksOnWhenAllValvesLoseHalfTheirGain) {
  const robot::Robot hyq = robot::load_robot(FARRIER_ROBOTS "hyq.yaml", {.on_ground = true}).value();
  const auto row = std::ranges::find(plant_rows(), std::string("coil_lost"), &PlantRow::name);
  const StudyCondition& fast = kStudyConditions[1];
  const auto ends = [&](const char* name) {
    for (StudyDesign design : study_designs(hyq, hyq)) {
      if (design.name == name) {
        design.robot = with_gait(design.robot, fast);
        TrotCase one = study_case(design, *row, fast, 1);
        one.judged_until_s = one.end_s = 16.0;
        return run_trot_case(design.robot, one, Joints::kActuators).value().value();
      }
    }
    return TrotFigures{};
  };
  EXPECT_TRUE(ends(kNominal).fell_s.has_value());
  const TrotFigures adapted = ends(kAdaptive);
  EXPECT_FALSE(adapted.fell_s.has_value()) << *adapted.fell_s;
  EXPECT_GT(adapted.adaptation->updates, 12);
  EXPECT_EQ(adapted.adaptation->invalid_updates, 0);
  EXPECT_EQ(adapted.adaptation->gains_refused, 0);
}

TEST(AdaptationStudy, GivesEachRowAScene) {
  const robot::Robot hyq = robot::load_robot(FARRIER_ROBOTS "hyq.yaml", {.on_ground = true}).value();
  for (const PlantRow& row : plant_rows()) {
    const StudyDesign design{.name = "one", .sentence = "", .robot = hyq};
    const auto scene = world::load_scene_text(study_case(design, row, kStudyConditions[0], 1).scene, row.name);
    ASSERT_TRUE(scene) << config::to_string(scene.error());
    const std::size_t joints = row.first_leg ? 3 : hyq.joints.size();
    const std::size_t changes = scene.value().actuator_changes.size();
    EXPECT_TRUE(changes == 0 || changes == joints || (row.later && changes == 2 * joints)) << row.name;
    EXPECT_EQ(changes + scene.value().payloads.size() == 0, std::string(row.name) == "nominal") << row.name;
  }
}

TEST(FixedSearch, KeepsTheQuarterWithTheFewestFallsAndDrawsOthersAroundIt) {
  const robot::Robot hyq = robot::load_robot(FARRIER_ROBOTS "hyq.yaml", {.on_ground = true}).value();
  FixedSearch search(hyq, false);
  const std::size_t first = search.candidates().size();
  const auto jobs = search.next();
  std::vector<TrotRow> rows;
  for (const TrotJob& job : jobs) {
    rows.push_back({.trial = job.one.trial, .name = job.one.name, .figures = {}, .failure = {}});
    // Candidate 7 never falls, the others do once.
    if (!job.one.name.starts_with("candidate 7,") && job.one.trial == "gain_50, easy") {
      rows.back().figures.fell_s = 9.0;
    }
  }
  search.take(rows);
  ASSERT_EQ(search.candidates().size(), first);
  const FixedSearch::Candidate& best = search.candidates().front();
  EXPECT_EQ(best.number, 7);
  EXPECT_EQ(best.falls, 0);
  const FixedSearch::Candidate& around_best = search.candidates()[first / 4];
  EXPECT_GE(around_best.number, static_cast<int>(first));
  EXPECT_EQ(around_best.runs, 0);
  EXPECT_NEAR(around_best.gains.force_1_s, best.gains.force_1_s, 100.0);
  EXPECT_NE(around_best.gains.force_1_s, best.gains.force_1_s);
}

}  // namespace body_adaptation_test
}  // namespace farrier::trials
