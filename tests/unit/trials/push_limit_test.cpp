#include "trials/body/push_limit.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <string>

namespace farrier::trials {
namespace push_limit_test {

class PushLimitOfHyq : public testing::Test {
 protected:
  /// Searches a robot of which half the phases fall from `weak_Ns` and the others from `strong_Ns` on.
  std::vector<PushLimit> search(double weak_Ns, double strong_Ns) {
    PushLimitSearch search(hyq_);
    for (auto cases = search.next(); !cases.empty(); cases = search.next()) {
      ++rounds_;
      std::vector<TrotRow> rows;
      for (const TrotCase& one : cases) {
        EXPECT_EQ(one.trial, PushLimitSearch::kTrial);
        EXPECT_TRUE(seen_.emplace(one.name, true).second) << one.name << " again";
        const double impulse_Ns = std::atof(one.name.c_str());
        const bool weak =
            one.name.find("phase 0") != std::string::npos || one.name.find("phase 2") != std::string::npos ||
            one.name.find("phase 4") != std::string::npos || one.name.find("phase 6") != std::string::npos;
        TrotRow row{.trial = one.trial, .name = one.name, .figures = {}, .failure = {}};
        if (impulse_Ns >= (weak ? weak_Ns : strong_Ns)) {
          row.figures.fell_s = 15.0;
        }
        rows.push_back(row);
      }
      search.take(rows);
    }
    return search.limits();
  }

  const robot::Robot hyq_ = robot::load_robot(FARRIER_ROBOTS "hyq.yaml").value();
  std::map<std::string, bool> seen_;
  int rounds_ = 0;
};

TEST_F(PushLimitOfHyq, IsWhereHalfOfThePhasesFall) {
  const std::vector<PushLimit> limits = search(200.0, 300.0);
  ASSERT_EQ(limits.size(), 4u);
  for (const PushLimit& limit : limits) {
    EXPECT_GE(limit.half_Ns.value(), 200.0) << limit.side;
    EXPECT_LT(limit.fewer_Ns, 200.0);
    EXPECT_NEAR(limit.half_Ns.value() - limit.fewer_Ns, PushLimitSearch::kResolution_Ns, 1e-9);
  }
  EXPECT_LE(rounds_, 7) << "224 runs";
}

TEST_F(PushLimitOfHyq, IsUnknownWhereFewerFallByTheLargest) {
  for (const PushLimit& limit : search(1e4, 1e4)) {
    EXPECT_FALSE(limit.half_Ns.has_value());
    EXPECT_EQ(limit.fewer_Ns, PushLimitSearch::kLargest_Ns);
  }
  EXPECT_EQ(rounds_, 1);
}

TEST_F(PushLimitOfHyq, EndsWhereEveryPushFalls) {
  for (const PushLimit& limit : search(0.0, 0.0)) {
    EXPECT_EQ(limit.fewer_Ns, 0.0);
    EXPECT_EQ(limit.half_Ns, PushLimitSearch::kResolution_Ns);
  }
}

TEST_F(PushLimitOfHyq, CountsAMissingRunAsAFall) {
  PushLimitSearch search(hyq_);
  search.take({});
  EXPECT_EQ(search.limits().front().half_Ns, PushLimitSearch::kLargest_Ns);
}

TEST(TrotCases, AreInProportionToTheRobot) {
  const robot::Robot hyq = robot::load_robot(FARRIER_ROBOTS "hyq.yaml").value();
  EXPECT_EQ(scaled_impulse_Ns(hyq, 80.0), 80.0);
  EXPECT_EQ(trot_cases(hyq).front().trunk_mass_kg, 51.0);
  const robot::Robot hexapod = robot::load_robot(FARRIER_ROBOTS "hexapod.yaml").value();
  EXPECT_EQ(scaled_impulse_Ns(hexapod, 80.0), 120.0) << "1.5 times as heavy";
  EXPECT_EQ(trot_cases(hexapod).front().trunk_mass_kg, 77.0);
}

}  // namespace push_limit_test
}  // namespace farrier::trials
