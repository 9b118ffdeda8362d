#include "thesis/report/claims.hpp"
#include "thesis/report/pinned_verdicts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace farrier::thesis {
namespace reproduce_claims_test {

using thesis::ClaimSpec;
using thesis::Relation;
using thesis::StudyResult;

constexpr ClaimSpec kClaims[] = {{"9.99.first", "9.9", "the first is small", "first", "1", Relation::kAtMost, 1.0},
                                 {"9.99.second", "9.9", "the second is large", "second", "s", Relation::kAtLeast, 5.0,
                                  thesis::Refutation{"it is not", 0.0, 4.0}},
                                 {"9.99.third", "9.9", "the third is small", "third", "1", Relation::kBelow, 1.0}};

Result<StudyResult> unused(const thesis::StudyContext&) { return StudyResult{}; }

StudyRun run_of(Result<StudyResult> result) {
  return {{"9.99", "title", kClaims, unused}, {{.seed = 1, .result = std::move(result)}}};
}

constexpr ClaimSpec kNoisyClaims[] = {
    needs(Condition::kPerfectMeasurements, {"9.99.large", "9.9", "it is large", "size", "1", Relation::kAtLeast, 1.0}),
    fails("other signals, which gave 3", {"9.99.small", "9.9", "it is small", "size", "1", Relation::kAtMost, 1.0}),
    proof({"9.99.ours", "9.9", "it is small", "size", "1", Relation::kAtMost, 1.0})};

/// A run over three seeds whose values are `values`; under its condition the first claim has ten times as much.
StudyRun run_over(std::vector<double> values) {
  StudyRun run{{"9.99", "title", kNoisyClaims, unused}, {}};
  for (const double value : values) {
    run.seeds.push_back({.seed = run.seeds.size() + 1,
                         .result = StudyResult{{{"9.99.large", value, "", 10.0 * value},
                                                {"9.99.small", value, number_as("of %g", value)},
                                                {"9.99.ours", value, ""}},
                                               {}}});
  }
  return run;
}

StudyRun mixed() {
  return run_of(StudyResult{{{"9.99.second", 2.0, "a note"}, {"9.99.first", 0.5, ""}, {"9.99.third", 7.0, ""}}, {}});
}

TEST(Claims, StandInTheirOrderWithTheirVerdicts) {
  const auto claims = claims_of(mixed());
  ASSERT_EQ(claims.size(), 3u);
  EXPECT_EQ(claims[0].id, "9.99.first");
  EXPECT_EQ(claims[0].verdict, "holds");
  EXPECT_EQ(claims[1].verdict, "refuted");
  EXPECT_NE(claims[1].reason.find("it is not"), std::string::npos);
  EXPECT_NE(claims[1].reason.find("a note"), std::string::npos);
  EXPECT_EQ(claims[2].verdict, "fails");
}

TEST(Claims, NoneIsDroppedWhenItIsNotMeasuredOrTheStudyCannotRun) {
  const auto unmeasured = claims_of(run_of(StudyResult{{{"9.99.first", 0.5, ""}}, {}}));
  ASSERT_EQ(unmeasured.size(), 3u);
  EXPECT_EQ(unmeasured[0].verdict, "holds");
  EXPECT_EQ(unmeasured[1].verdict, "fails");
  const auto refused = claims_of(run_of(Error{"no robot file"}));
  ASSERT_EQ(refused.size(), 3u);
  for (const report::Claim& claim : refused) {
    EXPECT_EQ(claim.verdict, "fails");
    EXPECT_NE(claim.reason.find("no robot file"), std::string::npos);
  }
}

TEST(ClaimsDeathTest, AMeasurementWithoutAClaimIsABug) {
  EXPECT_DEATH((void)claims_of(run_of(StudyResult{{{"9.99.fourth", 0.5, ""}}, {}})),
               "claims nothing called 9.99.fourth");
}

TEST(Claims, AreJudgedByTheMedianOverTheSeedsAndKeepTheWorst) {
  const auto claims = claims_of(run_over({0.5, 7.0, 2.0}));
  EXPECT_EQ(claims[0].value, 2.0);
  EXPECT_EQ(claims[0].worst, 0.5);
  EXPECT_EQ(claims[0].verdict, "holds");
  EXPECT_EQ(claims[0].values, (std::vector<double>{0.5, 7.0, 2.0}));
  EXPECT_EQ(claims[1].value, 2.0);
  EXPECT_EQ(claims[1].worst, 7.0) << "a small value is claimed";
  EXPECT_EQ(claims[1].verdict, "fails");
  EXPECT_NE(claims[1].reason.find("of 2"), std::string::npos) << "the note of the median's run: " << claims[1].reason;
  EXPECT_EQ(claims[1].tried, "other signals, which gave 3");
}

TEST(Claims, MissingValueOfOneSeedIsTheWorst) {
  const auto claims = claims_of(run_over({0.5, std::nan(""), 0.25}));
  EXPECT_EQ(claims[1].value, 0.5);
  EXPECT_TRUE(std::isnan(claims[1].worst));
  EXPECT_EQ(claims[1].verdict, "holds");
  EXPECT_EQ(claims[1].tried, "") << "nothing is tried for a claim that holds";
}

TEST(Claims, ThatNeedTheirConditionShowBothValues) {
  const auto claims = claims_of(run_over({0.5, 0.25, 0.3}));
  EXPECT_EQ(claims[0].verdict, "needs");
  EXPECT_EQ(claims[0].value, 0.3);
  ASSERT_TRUE(claims[0].condition.has_value());
  EXPECT_EQ(claims[0].condition->value, 3.0);
  EXPECT_EQ(claims[0].condition->worst, 2.5);
  EXPECT_EQ(claims[0].condition->name, "perfect measurements");
  EXPECT_FALSE(claims[1].condition.has_value());
}

TEST(Claims, AreCountedByKindAndThoseThatFailStandFirst) {
  report::Outcome outcome;
  add_claims(outcome, claims_of(mixed()));
  add_claims(outcome, claims_of(run_over({2.0, 2.0, 2.0})));
  EXPECT_EQ(totals_text(outcome),
            "claims of the text: 2 hold, 0 need a condition, 1 are refuted, 2 fail\n"
            "proofs of ours: 0 hold, 0 need a condition, 0 are refuted, 1 fail\n");
  EXPECT_EQ(outcome.claims[0].id, "9.99.third");
  EXPECT_EQ(outcome.claims[1].id, "9.99.small");
  EXPECT_EQ(outcome.claims[3].id, "9.99.first");
  const auto totals = nlohmann::json::parse(report::to_json(outcome))["totals"];
  EXPECT_EQ(totals["text"]["fails"], 2);
  EXPECT_EQ(totals["proof"]["fails"], 1);
  EXPECT_FALSE(totals.contains("aim"));
}

TEST(Claims, BoundTheirFigureOnlyWhenTheyHold) {
  report::Outcome outcome;
  add_claims(outcome, claims_of(mixed()));
  EXPECT_TRUE(outcome.passes()) << "the pinned list decides about the exit status";
  EXPECT_TRUE(outcome.figures.find("reproduce.9.99.first")->bound.has_value());
  const report::Figure* refuted = outcome.figures.find("reproduce.9.99.second");
  ASSERT_NE(refuted, nullptr);
  EXPECT_FALSE(refuted->bound.has_value());
  EXPECT_EQ(std::string(refuted->spec->unit), "s");
}

TEST(PinnedVerdicts, NameAClaimThatSlides) {
  report::Claim claim;
  claim.id = "8.9.order";
  claim.verdict = "refuted";
  EXPECT_TRUE(slides({claim}).empty());
  claim.verdict = "holds";
  EXPECT_EQ(slides({claim}), (std::vector<std::string>{"8.9.order is pinned as 'refuted' and is now 'holds'"}));
  claim.id = "8.9.new";
  EXPECT_EQ(slides({claim}), (std::vector<std::string>{"8.9.new has the verdict 'holds' and none is pinned"}));
}

TEST(PinnedVerdicts, ArePrintedAsTheirFileHasThem) {
  report::Claim first, second;
  first.id = "2.1.b";
  first.verdict = "fails";
  second.id = "2.1.a";
  second.verdict = "needs";
  const std::string text = pinned_text({first, second});
  EXPECT_NE(text.find("\nFARRIER_PINNED(\"2.1.a\", kNeeds) FARRIER_PINNED(\"2.1.b\", kFails)\n"), std::string::npos)
      << text;
}

TEST(Claims, StandInTheJsonWithWhatWasMeasured) {
  report::Outcome outcome;
  outcome.command = "reproduce";
  add_claims(outcome, claims_of(run_of(Error{"no"})));
  add_claims(outcome, {});
  const auto json = nlohmann::json::parse(report::to_json(outcome));
  ASSERT_EQ(json["claims"].size(), 3u);
  const auto& second = json["claims"][1];
  EXPECT_EQ(second["id"], "9.99.second");
  EXPECT_EQ(second["figure"], "9.99");
  EXPECT_EQ(second["section"], "9.9");
  EXPECT_EQ(second["sentence"], "the second is large");
  EXPECT_EQ(second["measured"]["name"], "reproduce.9.99.second");
  EXPECT_TRUE(second["measured"]["value"].is_null()) << "could not be measured";
  EXPECT_EQ(second["measured"]["relation"], ">=");
  EXPECT_EQ(second["measured"]["bound"], 5.0);
  EXPECT_EQ(second["verdict"], "fails");
}

TEST(Figures, NoClaimJudgesStandBesideTheClaims) {
  StudyRun run = mixed();
  thesis::StudyResult result = run.seeds[0].result.value();
  result.figures = {{"9.99.besides", 2.5, "dB", "What stands beside."}};
  run.seeds[0].result = result;
  report::Outcome outcome;
  add_figures(outcome, run);
  const report::Figure* figure = outcome.figures.find("reproduce.9.99.besides");
  ASSERT_NE(figure, nullptr);
  EXPECT_EQ(figure->value, 2.5);
  EXPECT_FALSE(figure->bound.has_value());
  EXPECT_TRUE(outcome.passes());
  EXPECT_EQ(figure_text(result.figures[0]), "9.99.besides  2.5 dB\n");
}

TEST(Claims, AreListedWithTheirBounds) {
  const std::string text = listing(mixed().study);
  EXPECT_TRUE(text.starts_with("9.99  title\n"));
  EXPECT_NE(text.find("9.99.second: second [>= 5 s; 9.9]"), std::string::npos) << text;
}

}  // namespace reproduce_claims_test
}  // namespace farrier::thesis
