// Arithmetic of calibration on statements whose answer is known, and the maps of confidence that are shipped.

#include "trials/blind/calibration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/noise.hpp"
#include "trials/blind/score.hpp"

namespace farrier::blind {
namespace calibration_test {

constexpr double kTrue = 0.7;  ///< log odds per unit of the certainty that counts in made-up trials

/// Trials of one name each, right with the probability of a logistic map of its deviations from neutral. The fit is off by
/// half a deviation more than it says.
std::vector<Outcome> made_up(std::size_t count, const char* stream_name) {
  const NoiseStream stream(7, "calibration test", stream_name);
  std::vector<Outcome> outcomes;
  for (std::size_t i = 0; i < count; ++i) {
    const Tick at = static_cast<Tick>(4 * i);
    Named named{"load_mass", 1.0, 0.5};
    named.evidence.deviations = std::exp(6.0 * stream.uniform(at));
    const double certain = diagnosis::certainties(named.evidence)[7];
    const bool right = stream.uniform(at + 1) < 1.0 / (1.0 + std::exp(2.0 - kTrue * certain));
    named.fit_deviation = 0.01;
    named.distance = 0.2;
    if (right) {
      named.fit_error = std::abs(0.015 * stream.normal(at + 2));
      named.size_error = *named.fit_error / named.distance;
    }
    Outcome outcome;
    outcome.plan.kind = Kind::kEffect;
    outcome.plan.plan.hidden = {{right ? "load_mass" : "load_damping", 1}};
    outcome.named = {named};
    outcomes.push_back(outcome);
  }
  return outcomes;
}

/// The same trials with what a map makes of them.
std::vector<Outcome> judged(std::vector<Outcome> outcomes, const diagnosis::ConfidenceMap& map) {
  for (Outcome& outcome : outcomes) {
    for (Named& named : outcome.named) {
      named.confidence = diagnosis::confidence_of(named.evidence, map);
      named.deviation = diagnosis::covering_deviation(named.fit_deviation, named.distance, map);
    }
  }
  return outcomes;
}

TEST(Calibration, FiguresOfTwoStatementsAreThoseByHand) {
  const Calibration c = calibration_of({{0.8, true}, {0.8, false}});
  EXPECT_EQ(c.statements, 2u);
  EXPECT_NEAR(c.brier, (0.04 + 0.64) / 2.0, 1e-12);
  // sum of (y - p)(1 - 2 p) over the root of the sum of (1 - 2 p)^2 p (1 - p)
  EXPECT_NEAR(c.spiegelhalter_z, (-0.6) * (0.2 - 0.8) / std::sqrt(2.0 * 0.36 * 0.16), 1e-12);
  EXPECT_NEAR(c.error, (0.2 + 0.8) / 2.0, 1e-12);
  EXPECT_EQ(c.most, 0.8);
  EXPECT_TRUE(std::isnan(calibration_of({}).brier));
}

TEST(Calibration, TrueConfidencesHaveTheErrorThatIsExpectedAndOverconfidentOnesMore) {
  const NoiseStream stream(3, "calibration test", "forecasts");
  std::vector<Statement> honest;
  std::vector<Statement> bold;
  for (Tick i = 0; i < 800; ++i) {
    const double p = 0.5 + 0.49 * stream.uniform(2 * i);
    const bool right = stream.uniform(2 * i + 1) < p;
    honest.push_back({p, right});
    bold.push_back({0.5 + 0.5 * p, right});
  }
  const Calibration one = calibration_of(honest);
  EXPECT_LT(std::abs(one.spiegelhalter_z), 2.0);
  EXPECT_LT(std::abs(one.error - one.expected), 0.015);
  const Calibration other = calibration_of(bold);
  EXPECT_GT(std::abs(other.spiegelhalter_z), 2.0);
  EXPECT_GT(other.error - other.expected, 0.05);
}

TEST(Calibration, TheBandOfACoverageIsWilsons) {
  std::vector<Outcome> outcomes(100);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    Named named{"load_mass", 1.0, 0.5};
    named.deviation = 1.0;
    named.fit_error = i < 95 ? 1.0 : 3.0;
    outcomes[i].named = {named};
  }
  const Coverage c = coverage_of(outcomes);
  EXPECT_EQ(c.sizes, 100u);
  EXPECT_DOUBLE_EQ(c.share, 0.95);
  EXPECT_NEAR(c.low, 0.8882, 5e-4);
  EXPECT_NEAR(c.high, 0.9785, 5e-4);
}

TEST(Calibration, AMapHoldsOnTrialsThatItWasNotFittedTo) {
  const auto map = fitted_map(made_up(1200, "fitted"));
  ASSERT_TRUE(map);
  EXPECT_NEAR(map->weights[7], kTrue, 0.15);
  EXPECT_TRUE(std::ranges::all_of(map->weights, [](double weight) { return weight >= 0.0; }));
  const std::vector<Outcome> others = judged(made_up(1200, "tested"), *map);
  const Calibration c = calibration_of(statements_of(others));
  EXPECT_LT(std::abs(c.spiegelhalter_z), 2.0);
  EXPECT_LT(c.error - c.expected, 0.03);
  EXPECT_LE(c.most, 1.0 - 1.0 / 1200.0);
  const Coverage covered = coverage_of(others);
  EXPECT_GT(covered.share, 0.93);
  EXPECT_LE(covered.low, 0.95);
  EXPECT_GE(covered.high, 0.95);
}

TEST(Calibration, AMapNeedsRightAndWrongNames) { EXPECT_FALSE(fitted_map({})); }

TEST(ConfidenceMaps, ThatAreShippedRiseWithEveryCertaintyAndStayBelowWhatTheirTrialsCanShow) {
  for (const bool electric : {false, true}) {
    const diagnosis::ConfidenceMap& map = diagnosis::confidence_map(electric);
    EXPECT_GE(map.trials, 100.0);
    EXPECT_GT(*std::ranges::max_element(map.weights), 0.0);
    EXPECT_TRUE(std::ranges::all_of(map.weights, [](double weight) { return weight >= 0.0; }));
    EXPECT_GE(map.widening, 1.0);
    diagnosis::Evidence clear{.gain = 5.0, .deviations = 300.0};
    EXPECT_LE(diagnosis::confidence_of(clear, map), 1.0 - 1.0 / map.trials);
    diagnosis::Evidence doubtful = clear;
    doubtful.own_left = doubtful.all_left = 10.0;
    doubtful.unexplained = 0.5;
    doubtful.runner_up = 1.2;
    EXPECT_LT(diagnosis::confidence_of(doubtful, map), diagnosis::confidence_of(clear, map));
  }
}

TEST(ConfidenceMaps, KeepTheirFiguresInFilesOfTrials) {
  const diagnosis::Evidence evidence{.rival_chance = 0.9, .runner_up = 0.3, .own_left = 1.2, .effects = 3.0};
  EXPECT_EQ(diagnosis::numbers_of(diagnosis::evidence_of(diagnosis::numbers_of(evidence))),
            diagnosis::numbers_of(evidence));
}

TEST(HealthyRobots, AnAlarmIsOfARobotAndTheLastMayBeIncomplete) {
  const std::vector<TrialPlan> plans = healthy_trials(3, 4, 5);
  ASSERT_EQ(plans.size(), 12u);
  std::vector<Outcome> outcomes(11);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    outcomes[i].plan = plans[i];
  }
  EXPECT_EQ(alarms_of(outcomes, 3).robots, 3u);
  EXPECT_EQ(alarms_of(outcomes, 3).alarms, 0u);
  EXPECT_NEAR(alarms_of(outcomes, 3).rate_high, 1.96 * 1.96 / (3.0 + 1.96 * 1.96), 1e-4);
  outcomes[3].verdict = outcomes[4].verdict = diagnosis::Verdict::kEffects;
  EXPECT_EQ(alarms_of(outcomes, 3).alarms, 1u);
  EXPECT_EQ(alarms_of(outcomes, 3).joint_alarms, 2u);
}

}  // namespace calibration_test
}  // namespace farrier::blind
