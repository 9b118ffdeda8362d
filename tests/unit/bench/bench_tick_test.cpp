#include <gtest/gtest.h>

#include "bench/bench_estimators.hpp"
#include "bench/bench_redesign.hpp"
#include "bench/bench_tick.hpp"
#include "tests/unit/robot/test_files.hpp"

namespace farrier::bench {
namespace bench_tick_test {

TEST(TickBench, TimesHyQsJointsInATrotWithoutARedesign) {
  const auto bench = bench_tick(robot::load_shipped("hyq"), 1);
  ASSERT_TRUE(bench.ok()) << bench.error().message;
  EXPECT_GT(bench.value().control_s, 0.0);
  EXPECT_GT(bench.value().estimation_s, 0.0);
  EXPECT_GT(bench.value().update_logic_s, 0.0);
  EXPECT_EQ(bench.value().allocations, -1) << "not counted";
}

TEST(EstimatorsBench, TimesEveryMethodAndOpenGates) {
  const EstimatorsBench bench = bench_estimators(400, nullptr);
  for (const auto& method : bench.methods) {
    EXPECT_GT(method.take_s, 0.0) << method.name;
  }
  EXPECT_EQ(bench.allocations, -1) << "not counted";
}

TEST(RedesignBench, TimesAtLeastAsManyAcceptedRedesignsAsThereAreJoints) {
  const robot::Robot hyq = robot::load_shipped("hyq");
  const auto bench = bench_redesign(hyq, 1);
  ASSERT_TRUE(bench.ok()) << bench.error().message;
  EXPECT_GE(bench.value().redesigns, static_cast<int>(hyq.joints.size()));
  EXPECT_GT(bench.value().redesign_s, 0.0);
  EXPECT_GT(bench.value().lqr_s, 0.0);
}

TEST(RedesignBench, RefusesALogicThatAcceptsNothing) {
  robot::Robot hyq = robot::load_shipped("hyq");
  hyq.update_logic.validity_min = 1.0;
  const auto bench = bench_redesign(hyq, 1);
  ASSERT_FALSE(bench.ok());
  EXPECT_NE(bench.error().message.find("no estimate"), std::string::npos) << bench.error().message;
}

}  // namespace bench_tick_test
}  // namespace farrier::bench
