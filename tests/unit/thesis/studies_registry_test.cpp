#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "thesis/report/pinned_verdicts.hpp"
#include "thesis/studies/registry.hpp"

namespace farrier::thesis {
namespace studies_registry_test {

constexpr ClaimSpec kClaim{
    "1.2.name", "1.2", "words", "what", "1", Relation::kAtMost, 2.0, Refutation{"because", 3.0, 4.0}};

TEST(Judging, HoldsWhenTheRelationDoesAndAtItsBound) {
  EXPECT_EQ(judge(kClaim, 1.0), Verdict::kHolds);
  EXPECT_EQ(judge(kClaim, 2.0), Verdict::kHolds);
  ClaimSpec below = kClaim;
  below.relation = Relation::kBelow;
  below.refutation.reset();
  EXPECT_EQ(judge(below, 2.0), Verdict::kFails);
}

TEST(Judging, RefutesOnlyWhereTheReasonPredictsTheValue) {
  EXPECT_EQ(judge(kClaim, 3.0), Verdict::kRefuted);
  EXPECT_EQ(judge(kClaim, 4.0), Verdict::kRefuted);
  EXPECT_EQ(judge(kClaim, 2.5), Verdict::kFails);
  EXPECT_EQ(judge(kClaim, 4.5), Verdict::kFails);
}

TEST(Judging, WhatIsNotFiniteFails) {
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(judge(kClaim, value), Verdict::kFails) << value;
  }
}

TEST(Judging, NeedsItsConditionWhereTheRelationHoldsUnderThatAlone) {
  ClaimSpec claim = needs(Condition::kPerfectMeasurements, kClaim);
  EXPECT_EQ(judge(claim, 1.0, 2.5), Verdict::kHolds);
  EXPECT_EQ(judge(claim, 2.5, 1.0), Verdict::kNeeds);
  EXPECT_EQ(judge(claim, 3.5, 1.0), Verdict::kRefuted);
  EXPECT_EQ(judge(claim, 2.5, 2.5), Verdict::kFails);
  EXPECT_EQ(judge(claim, 2.5), Verdict::kFails);
  EXPECT_EQ(judge(kClaim, 2.5, 1.0), Verdict::kFails) << "a claim without a condition";
}

TEST(Judging, KnowsARefutationThatTouchesItsBound) {
  EXPECT_TRUE(keeps_its_gap(kClaim));
  for (const auto& [at_least, at_most] : {std::pair{2.0, 4.0}, {2.1, 4.0}, {1.0, 1.5}, {3.0, HUGE_VAL}, {4.0, 3.0}}) {
    ClaimSpec claim = kClaim;
    claim.refutation = Refutation{"because", at_least, at_most};
    EXPECT_FALSE(keeps_its_gap(claim)) << at_least << " to " << at_most;
  }
  ClaimSpec lower = kClaim;
  lower.relation = Relation::kAtLeast;
  lower.refutation = Refutation{"because", 0.0, 1.0};
  EXPECT_TRUE(keeps_its_gap(lower));
}

TEST(Registry, RefutationsKeepAGapFromTheirBounds) {
  for (const Study& study : all_studies()) {
    for (const ClaimSpec& claim : study.claims) {
      EXPECT_TRUE(keeps_its_gap(claim)) << claim.id;
    }
  }
}

TEST(Conditions, AreFewHaveASourceAndServeMoreThanOneClaim) {
  EXPECT_LE(conditions().size(), kMostConditions);
  for (const ConditionSpec& condition : conditions()) {
    EXPECT_NE(std::string(condition.name), "");
    EXPECT_NE(std::string(condition.meaning), "") << condition.name;
    EXPECT_NE(std::string(condition.source), "") << condition.name;
    int used = 0;
    for (const Study& study : all_studies()) {
      used += static_cast<int>(std::ranges::count(study.claims, condition.condition, &ClaimSpec::condition));
    }
    EXPECT_GE(used, 2) << condition.name;
  }
}

TEST(PinnedVerdicts, AreThoseOfTheClaimsAndSayWhatWasTriedForOneThatFails) {
  std::set<std::string> claims, pinned;
  for (const Study& study : all_studies()) {
    for (const ClaimSpec& claim : study.claims) {
      claims.insert(claim.id);
      if (pinned_verdict(claim.id) == Verdict::kFails) {
        EXPECT_NE(std::string(claim.tried), "") << claim.id;
      }
    }
  }
  for (const PinnedVerdict& one : pinned_verdicts()) {
    EXPECT_TRUE(pinned.insert(one.id).second) << one.id << " is pinned twice";
  }
  EXPECT_EQ(pinned, claims);
}

std::string prefix_of(const Study& study) {
  const std::string number = study.number;
  return (number.starts_with('T') ? number.substr(1) : number) + ".";
}

TEST(Registry, EveryStudyHasItsOwnNumberATitleAndClaimsUnlessItShowsInputs) {
  std::set<std::string> numbers;
  for (const Study& study : all_studies()) {
    EXPECT_TRUE(numbers.insert(study.number).second) << study.number;
    EXPECT_NE(std::string(study.title), "") << study.number;
    EXPECT_TRUE(!study.claims.empty() || std::string(study.conditions).find("inputs of ours") != std::string::npos)
        << study.number;
    EXPECT_NE(study.run, nullptr) << study.number;
  }
  EXPECT_GE(numbers.size(), 20u);
}

TEST(Registry, EveryClaimIsNamedAfterItsFigureOnceAndSaysWhereItStands) {
  std::set<std::string> ids;
  for (const Study& study : all_studies()) {
    for (const ClaimSpec& claim : study.claims) {
      const std::string id = claim.id;
      EXPECT_TRUE(ids.insert(id).second) << id << " is claimed twice";
      EXPECT_TRUE(id.starts_with(prefix_of(study))) << id << " of " << study.number;
      EXPECT_TRUE(std::string_view(study.number).starts_with('T') ||
                  id.find('.', prefix_of(study).size()) == std::string::npos)
          << id << ": only a table's claims have further parts";
      EXPECT_TRUE(std::isfinite(claim.bound)) << id;
      EXPECT_NE(std::string(claim.sentence), "") << id;
      EXPECT_NE(std::string(claim.section), "") << id;
    }
  }
}

TEST(Registry, StudiesStandInTheOrderOfTheText) {
  const auto place = [studies = all_studies()](const char* number) {
    return find_study(studies, number) - studies.data();
  };
  EXPECT_LT(place("4.9"), place("4.10"));
  EXPECT_LT(place("4.10"), place("7.2"));
  EXPECT_LT(place("8.11"), place("A.2"));
  EXPECT_LT(place("A.2"), place("C.3"));
}

TEST(Registry, AnUnknownNumberIsAnsweredWithThoseOfItsChapter) {
  const auto studies = all_studies();
  EXPECT_EQ(find_study(studies, "7.1"), nullptr);
  const auto near = near_numbers(studies, "7.1");
  ASSERT_FALSE(near.empty());
  EXPECT_LE(near.size(), 8u);
  for (const std::string& number : near) {
    EXPECT_TRUE(number.starts_with("7.")) << number;
  }
  EXPECT_EQ(near_numbers(studies, ""), std::vector<std::string>{});
}

TEST(Spaces, BeginAndEndWhereTheyAreTold) {
  constexpr double kRounding = 1e-12;
  const auto linear = linear_space(-1.0, 3.0, 5);
  EXPECT_EQ(linear, (std::vector<double>{-1.0, 0.0, 1.0, 2.0, 3.0}));
  const auto logarithmic = log_space(1.0, 100.0, 3);
  EXPECT_NEAR(logarithmic[1], 10.0, 10.0 * kRounding);
  EXPECT_NEAR(logarithmic[2], 100.0, 100.0 * kRounding);
}

}  // namespace studies_registry_test
}  // namespace farrier::thesis
