#include "thesis/rig/rig_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "thesis/rig/bode.hpp"
#include "thesis/rig/gain_map.hpp"

namespace farrier::thesis {
namespace studies_rig_run_test {

constexpr double kPeriod_s = 1e-3;

/// 2 s in which a force lags `lag_deg` behind a reference of 5 Hz and has `gain` times its size.
RigTrace lagging(double lag_deg, double gain) {
  RigTrace run;
  run.period_s = kPeriod_s;
  for (int k = 0; k < 2000; ++k) {
    const double t = kPeriod_s * k;
    const double turn = 2.0 * std::numbers::pi * 5.0 * t;
    run.time_s.push_back(t);
    run.reference_N.push_back(100.0 * std::sin(turn));
    run.force_N.push_back(100.0 * gain * std::sin(turn - lag_deg * std::numbers::pi / 180.0));
    run.current_A.push_back(k < 500 ? 0.01 : -0.002);
  }
  return run;
}

TEST(RigFigures, LagIsThatOfTheForceBehindItsReference) {
  EXPECT_NEAR(lag_deg(lagging(30.0, 0.7), 5.0, 0.4), 30.0, 1e-6);
  EXPECT_NEAR(lag_deg(lagging(-20.0, 1.3), 5.0, 0.0), -20.0, 1e-6) << "ahead";
}

TEST(RigFigures, TrackingErrorIsRelativeToTheReference) {
  EXPECT_NEAR(tracking_error(lagging(0.0, 0.9), 0.0, 2.0), 0.1, 1e-9);
  EXPECT_NEAR(tracking_error(lagging(60.0, 1.0), 0.0, 2.0), 1.0, 1e-9) << "a chord of 60 degrees";
  EXPECT_TRUE(std::isnan(tracking_error(lagging(0.0, 1.0), 3.0, 4.0))) << "no ticks";
}

TEST(RigFigures, RippleIsWhatIsQuickerThanItsWindow) {
  RigTrace run = lagging(0.0, 1.0);
  std::vector<double> quick(run.time_s.size());
  for (std::size_t k = 0; k < quick.size(); ++k) {
    quick[k] = 5.0 + 1e-3 * static_cast<double>(k) + (k % 2 == 0 ? 1.0 : -1.0);
  }
  EXPECT_NEAR(ripple(run, quick, 0.1, 0.5, 1.5), 1.0, 0.02) << "neither the mean nor the slope";
}

TEST(Signals, AChirpReachesItsLastFrequencyAtItsEnd) {
  const Signal signal = chirp(2.0, 30.0, 8.0);
  EXPECT_NEAR(signal(8.0 - 0.5 / 30.0 + 1e-6), -signal(8.0), 0.05) << "half a period of 30 Hz before";
  EXPECT_EQ(signal(0.0), 0.0);
  double largest = 0.0;
  for (double t = 0.0; t < 8.0; t += kPeriod_s) {
    largest = std::max(largest, std::abs(signal(t)));
  }
  EXPECT_NEAR(largest, 2.0, 1e-3);
}

robot::Robot rig_of_tests() {
  StudyContext context;
  context.robots = FARRIER_ROBOTS;
  return load_rig(context).value();
}

TEST(RigRun, RepeatsItselfAndHearsItsSeed) {
  const robot::Robot rig = rig_of_tests();
  const Driving driving{.current_A = sine(1e-3, 5.0), .duration_s = 0.2};
  const RigTrace a = drive(rig, driving, 1).value();
  const RigTrace b = drive(rig, driving, 1).value();
  const RigTrace c = drive(rig, driving, 2).value();
  EXPECT_EQ(a.measured_force_N, b.measured_force_N);
  EXPECT_NE(a.measured_force_N, c.measured_force_N);
  EXPECT_EQ(a.force_N, c.force_N) << "nobody acts on what is measured";
}

TEST(RigRun, TracksAStepAndPutsWeightOnWhileItRuns) {
  const robot::Robot rig = rig_of_tests();
  Tracking tracking{.reference = [](double) { return 120.0; }, .duration_s = 1.0};
  const RigTrace light = track(rig, tracking, 1).value();
  EXPECT_LT(tracking_error(light, 0.5, 1.0), 0.1);
  tracking.added = {{0.5, 5.0}};
  const RigTrace heavier = track(rig, tracking, 1).value();
  EXPECT_EQ(light.force_N[499], heavier.force_N[499]);
  EXPECT_NE(light.force_N.back(), heavier.force_N.back());
}

TEST(Bode, ComparesWithinAFrequencyRange) {
  const std::vector<double> grid{1.0, 10.0, 100.0};
  const Response a{1.0, 1.0, 1.0};
  const Response b{1.0, 10.0, 100.0};
  EXPECT_NEAR(largest_difference_dB(grid, a, b, 1.0, 100.0), 40.0, 1e-12);
  EXPECT_NEAR(largest_difference_dB(grid, a, b, 1.0, 10.0), 20.0, 1e-12);
  EXPECT_EQ(largest_difference_dB(grid, a, b, 2.0, 9.0), 0.0);
  EXPECT_NEAR(magnitude_dB_near(grid, b, 20.0), 20.0, 1e-12);
}

TEST(GainMap, SaysHowAGainGoesOverAnAxis) {
  Map map{{"first", {1.0, 2.0, 3.0}, {}}, {"second", {1.0, 2.0}, {}}, {}};
  map.k = {
      {{0.0, -1.0, 5.0}, {0.0, -1.0, 5.0}}, {{0.0, -2.0, 5.0}, {0.0, -2.0, 5.0}}, {{0.0, -4.0, 5.0}, {0.0, -1.5, 5.0}}};
  EXPECT_DOUBLE_EQ(rising(map, kVelocity), 0.75);
  EXPECT_DOUBLE_EQ(change(map, kVelocity, 0), 0.75);
  EXPECT_DOUBLE_EQ(change(map, kVelocity, 1), 0.25);
  EXPECT_DOUBLE_EQ(change(map, kVelocity), 0.75);
  EXPECT_DOUBLE_EQ(change(map, kForce), 0.0);
  EXPECT_EQ(transposed(map).k[1][2][kVelocity], -1.5);
}

}  // namespace studies_rig_run_test
}  // namespace farrier::thesis
