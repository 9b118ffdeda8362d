#include "thesis/report/claims.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace farrier::thesis {
namespace reproduce_claims_test {

using thesis::ClaimSpec;
using thesis::Relation;
using thesis::StudyResult;

constexpr ClaimSpec kClaims[] = {
    {"9.99.first", "9.9", "the first is small", "first", "1", Relation::kAtMost, 1.0},
    {"9.99.second", "9.9", "the second is large", "second", "s", Relation::kAtLeast, 5.0, thesis::Refutation{"it is not", 0.0, 4.0}},
    {"9.99.third", "9.9", "the third is small", "third", "1", Relation::kBelow, 1.0}};

Result<StudyResult> unused(const thesis::StudyContext&) { return StudyResult{}; }

StudyRun run_of(Result<StudyResult> result) { return {{"9.99", "title", kClaims, unused}, std::move(result)}; }

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
  EXPECT_DEATH((void)claims_of(run_of(StudyResult{{{"9.99.fourth", 0.5, ""}}, {}})), "claims nothing called 9.99.fourth");
}

TEST(Claims, OneThatFailsFailsTheOutcomeAndOneThatIsRefutedDoesNot) {
  auto claims = claims_of(mixed());
  report::Outcome with_failure;
  add_claims(with_failure, claims);
  EXPECT_FALSE(with_failure.passes());
  claims.pop_back();
  report::Outcome without;
  add_claims(without, claims);
  EXPECT_TRUE(without.passes());
  const report::Figure* refuted = without.figures.find("reproduce.9.99.second");
  ASSERT_NE(refuted, nullptr);
  EXPECT_FALSE(refuted->bound.has_value());
  EXPECT_EQ(std::string(refuted->spec->unit), "s");
}

TEST(Claims, StandInTheJsonWithWhatWasMeasured) {
  report::Outcome outcome;
  outcome.command = "reproduce";
  add_claims(outcome, claims_of(run_of(Error{"no"})));
  add_claims(outcome, {});
  const auto json = nlohmann::json::parse(report::to_json(outcome));
  EXPECT_EQ(json["verdict"], "fail");
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
  thesis::StudyResult result = run.result.value();
  result.figures = {{"9.99.besides", 2.5, "dB", "What stands beside."}};
  run.result = result;
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
