#include "bench/bench_body.hpp"

#include <gtest/gtest.h>

#include "bench/bench_walk.hpp"
#include "tests/unit/robot/test_files.hpp"

namespace farrier::bench {
namespace bench_body_test {

TEST(BodyBench, FindsTheForcesOfAnotherSolverInATrot) {
  const auto bench = bench_body(robot::load_shipped("hyq"), 2);
  ASSERT_TRUE(bench.ok()) << bench.error().message;
  EXPECT_LT(bench.value().forces_difference, 0.02);
  EXPECT_GT(bench.value().run_ratio, 1.0) << "a tick has more than MuJoCo's steps";
  for (const double time_s : {bench.value().dynamics_s, bench.value().mujoco_dynamics_s, bench.value().forces_s,
                              bench.value().slsqp_s, bench.value().tick_s, bench.value().bare_step_s}) {
    EXPECT_GT(time_s, 0.0);
    EXPECT_LT(time_s, 0.01);
  }
  EXPECT_EQ(bench.value().allocations, -1) << "not counted";
}

TEST(WalkBench, TimesARobotOnItsOwnActuators) {
  const auto bench = bench_walk(robot::load_shipped("hyq", {.on_ground = true}), 1);
  ASSERT_TRUE(bench.ok()) << bench.error().message;
  EXPECT_GT(bench.value().run_ratio, 1.0) << "a tick has more than MuJoCo's steps";
  EXPECT_GT(bench.value().bare_step_s, 0.0);
  EXPECT_GT(bench.value().real_time, 0.01);
}

TEST(WalkBench, TimesWhatTheRobotComputesWhileItAdapts) {
  const auto bench = bench_control_tick(robot::load_shipped("hyq", {.on_ground = true}), 1);
  ASSERT_TRUE(bench.ok()) << bench.error().message;
  EXPECT_GT(bench.value().tick_s, 0.0);
  EXPECT_LT(bench.value().tick_s, 0.01);
  EXPECT_EQ(bench.value().allocations, -1) << "not counted";
}

TEST(BodyBench, RefusesARobotThatCannotWalk) {
  const auto bench = bench_body(robot::load_shipped("electric_leg"), 1);
  ASSERT_FALSE(bench.ok());
  EXPECT_EQ(bench.error().message, "electric_leg cannot walk on a ground: give body.trunk and locomotion in its file");
}

}  // namespace bench_body_test
}  // namespace farrier::bench
