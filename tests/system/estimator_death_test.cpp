// Without the estimator a robot goes on with the gains it has.

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <map>

#include "farrier_command.hpp"
#include "trace/trace.hpp"
#include "signals/signals.hpp"

namespace farrier::test {
namespace estimator_death_test {

constexpr long kTicks = 4000;
// A busy computer loses samples, and a joint damps for some ticks after each: that is no joint that has lost its torque,
// which would never track again. A twentieth of the run's samples may all be a tenth of those after the death.
constexpr double kMayBeLost = 0.05;
constexpr double kMayNotTrack = 0.25;
constexpr double kJoints = 12;
// The supervisor may still work on estimates that it has received, and the launcher searches ended processes every 20
// ms.
constexpr long kOnTheWayTicks = 100;

/// Rows of a joint, and those in which it tracks its torque.
struct Tracked {
  int all = 0, tracking = 0;

  void count(const trace::TraceRow& row) {
    ++all;
    tracking += row.state == signals::JointState::kTracking ? 1 : 0;
  }
  double share() const { return all > 0 ? static_cast<double>(tracking) / all : 0.0; }
};

/// A run in real time whose estimator_service is killed in the middle.
class EstimatorDeath : public testing::TestWithParam<const char*> {
 protected:
  EstimatorDeath()
      : trot_({"trot", "--world", "bench", "--clock", "realtime", "--nodes", "one", "--design", GetParam(),
               "--no-comparison", "--duration", "4", "--out", scratch_.file("out")}) {
    if (trot_.says("trot: tick 2")) {
      estimator_ = trot_.process("estimator_service");
      ::kill(estimator_, SIGKILL);
    }
    status_ = trot_.wait();
    run_ = read_json(scratch_.file("out/figures.json"));
  }

  /// "… after tick N: estimator_service …" in the only warning; -1 when there is none.
  long tick_of_death() const {
    const std::string warning = run_.contains("warnings") ? run_["warnings"][0].get<std::string>() : "";
    const std::string before = "after tick ";
    const std::size_t place = warning.find(before);
    return place == std::string::npos ? -1 : std::stol(warning.substr(place + before.size()));
  }

  /// Names of failures and of figures beyond their bound, without those of how the computer kept up.
  std::vector<std::string> broken() const {
    std::vector<std::string> names = run_.value("failures", std::vector<std::string>{});
    for (const auto& entry : run_["figures"]) {
      const std::string name = entry["name"];
      EXPECT_FALSE(name.starts_with("trot.bare_")) << "--no-comparison";
      if (!entry.value("holds", true) && name != "trot.missed_periods") {
        names.push_back(name);
      }
    }
    return names;
  }

  ScratchDirectory scratch_;
  FarrierCommand trot_;
  pid_t estimator_ = 0;
  int status_ = -1;
  nlohmann::json run_;
};

TEST_P(EstimatorDeath, StopsUpdatesAndNothingElse) {
  ASSERT_NE(estimator_, 0);
  ASSERT_FALSE(run_.is_discarded()) << trot_.output();
  EXPECT_NE(trot_.output().find("estimator_service (pid " + std::to_string(estimator_) +
                                ") ended with exit status 137, killed by Killed"),
            std::string::npos)
      << trot_.output();
  if (const double lost = figure(run_, "trot.lost_samples");
      lost > kMayBeLost * static_cast<double>(kTicks) * kJoints) {
    GTEST_SKIP() << "this computer lost " << lost << " samples on their way: that joints then miss ticks or trip says "
                 << "nothing of the estimator's death";
  }
  EXPECT_EQ(status_, run_["verdict"] == "pass" ? 0 : 1) << trot_.output();
  EXPECT_EQ(broken(), std::vector<std::string>{});
  const long death = tick_of_death();
  ASSERT_GT(death, 0);
  ASSERT_LT(death, kTicks - 1000) << "it died too late to see what comes after";
  for (const auto& decision : run_["run"]["decisions"]) {
    EXPECT_LE(decision["tick"].get<long>(), death + kOnTheWayTicks) << decision;
  }

  std::vector<std::string> joints;
  for (const char* leg : {"lf", "rf", "lh", "rh"}) {
    for (const char* joint : {"_haa", "_hfe", "_kfe"}) {
      joints.push_back(std::string(leg) + joint);
    }
  }
  const auto rows = trace::read_trace(scratch_.file("out/trace.csv"), joints);
  ASSERT_TRUE(rows) << rows.error().message;
  std::map<int, Tracked> after;
  Tick last = 0;
  for (const trace::TraceRow& row : rows.value()) {
    last = std::max(last, row.tick);
    if (row.tick > death) {
      after[row.joint].count(row);
    }
  }
  EXPECT_NEAR(static_cast<double>(last), static_cast<double>(kTicks), 2.0);
  ASSERT_EQ(after.size(), joints.size());
  for (const auto& [joint, tracked] : after) {
    EXPECT_GE(tracked.share(), 1.0 - kMayNotTrack) << joints[static_cast<std::size_t>(joint)];
  }
}

INSTANTIATE_TEST_SUITE_P(Of, EstimatorDeath, testing::Values("phases", "adaptive"),
                         [](const auto& design) { return std::string(design.param); });

}  // namespace estimator_death_test
}  // namespace farrier::test
