// Margins of the loop against a dense grid, against loops that are closed with them, and against what is known.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "control/design/closed_loop.hpp"
#include "control/design/margins.hpp"
#include "models.hpp"
#include "tests/support/allocation_guard.hpp"

namespace farrier::control {
namespace margins_test {

using testing::kNormalisation;

struct Case {
  const char* name;
  DiscreteModel model;
  Gains gains;
  int delay;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int delay : {0, 1, 2}) {
    for (const double mass_kg : {0.5, 2.5, 50.0}) {
      const DiscreteModel rig = testing::sampled(testing::fc1d(mass_kg));
      all.push_back({"fc1d", rig, design_lqr(rig, {}, kNormalisation, Form::kFullState, delay).value(), delay});
    }
    for (const double mass_kg : {2.5, 50.0}) {
      const DiscreteModel leg = testing::sampled(testing::hyq(mass_kg));
      all.push_back({"hyq", leg, design_lqr(leg, {}, kNormalisation, Form::kCompliant, delay).value(), delay});
    }
  }
  return all;
}

double disk_by_dense_grid(const Case& c) {
  constexpr int kPoints = 20000;
  constexpr double kFirst = 1e-3;
  double closest = 0.0;
  for (int i = 0; i <= kPoints; ++i) {
    const double angle = kFirst * std::pow(std::numbers::pi / kFirst, i / static_cast<double>(kPoints));
    const std::complex<double> l = loop_gain(c.model, c.gains, c.delay, {}, angle);
    closest = std::max(closest, 0.5 * std::abs((1.0 - l) / (1.0 + l)));
  }
  return 1.0 / closest;
}

/// Radius of the loop with the current multiplied by `factor` on its way to the plant; its own delay compensation
/// does not know.
double radius_with(const Case& c, double factor) {
  DiscreteModel changed = c.model;
  changed.b *= factor;
  return closed_loop_spectral_radius(changed, c.gains, c.delay);
}

TEST(Margins, DiskIsThatOfADenseGrid) {
  constexpr double kOnePercent = 0.01;  // as the header says
  for (const Case& c : cases()) {
    const Margins m = margins(c.model, c.gains, c.delay);
    const double dense = disk_by_dense_grid(c);
    EXPECT_NEAR(m.disk, dense, kOnePercent * dense) << c.name << ", delay " << c.delay;
    EXPECT_GT(m.disk, 0.0);
    EXPECT_LE(m.disk, 2.0 * (1.0 + 1e-9));
  }
}

TEST(Margins, GainsAtTheMarginPutPolesOnTheUnitCircle) {
  // Sixteen bisections of a grid step of 17 % leave the crossing to 3e-6, and the radius moves by about as much.
  constexpr double kTolerance = 1e-4;
  int seen = 0;
  for (const Case& c : cases()) {
    const Margins m = margins(c.model, c.gains, c.delay);
    if (std::isfinite(m.gain_up)) {
      EXPECT_NEAR(radius_with(c, m.gain_up), 1.0, kTolerance) << c.name << ", delay " << c.delay;
      EXPECT_LT(radius_with(c, 1.0 + 0.9 * (m.gain_up - 1.0)), 1.0);
      ++seen;
    }
    if (m.gain_down > 0.0) {
      EXPECT_NEAR(radius_with(c, m.gain_down), 1.0, kTolerance) << c.name << ", delay " << c.delay;
    }
    EXPECT_GE(m.gain_up, m.disk_gain() * (1.0 - 1e-3)) << "a disk holds less than its diameter";
    EXPECT_GE(m.phase_rad, m.disk_phase_rad() * (1.0 - 1e-3));
  }
  EXPECT_GT(seen, 0);
}

TEST(Margins, OneTickMoreIsStableExactlyWhenTheDelayMarginSaysSo) {
  int seen = 0;
  for (const Case& c : cases()) {
    for (int more = 1; c.delay + more <= kMaxDelayTicks; ++more) {
      const double margin = margins(c.model, c.gains, c.delay).delay_ticks;
      if (std::abs(margin - more) > 0.01) {
        EXPECT_EQ(closed_loop_spectral_radius(c.model, c.gains, c.delay + more) < 1.0, margin > more)
            << c.name << ", delay " << c.delay << " + " << more << ", margin " << margin;
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 5);
}

TEST(Margins, OfAnUnstableLoopAreZero) {
  const DiscreteModel rig = testing::sampled(testing::fc1d(50.0));
  Gains gains = design_lqr(rig, {}, kNormalisation, Form::kFullState, 0).value();
  gains.force *= -1.0;
  const Margins m = margins(rig, gains, 0);
  EXPECT_EQ(m.disk, 0.0);
  EXPECT_EQ(m.delay_ticks, 0.0);
  EXPECT_EQ(m.gain_up, 0.0);
}

TEST(Margins, OfWhatIsNotFiniteAreZero) {
  DiscreteModel rig = testing::sampled(testing::fc1d(50.0));
  const Gains gains = design_lqr(rig, {}, kNormalisation, Form::kFullState, 0).value();
  rig.a(2, 2) = std::nan("");
  EXPECT_EQ(margins(rig, gains, 0).disk, 0.0);
  EXPECT_EQ(margins(gains.model, gains, 7).disk, 0.0) << "no such delay";
}

/// First order, corner f: s+ = e s + (1 - e) y, filtered y = s+, at once.
MeasurementFilter low_pass(double corner_Hz) {
  const double keeps = std::exp(-2.0 * std::numbers::pi * corner_Hz * testing::kPeriodS);
  return {1, {1.0 - keeps}, {1.0, -keeps}};
}

TEST(Margins, AFilterThatPassesEverythingChangesNothing) {
  for (const Case& c : cases()) {
    const Margins bare = margins(c.model, c.gains, c.delay);
    const MeasurementFilter almost{2, {1.0 + 1e-15, -0.5}, {1.0, -0.5}};  // its state has no weight
    const Margins filtered = margins(c.model, c.gains, c.delay, {almost, almost, almost});
    EXPECT_NEAR(filtered.disk, bare.disk, 1e-6 * bare.disk) << c.name;
    EXPECT_NEAR(filtered.phase_rad, bare.phase_rad, 1e-4);
  }
}

TEST(Margins, ShrinkAsTheVelocityFilterLags) {
  const DiscreteModel leg = testing::sampled(testing::hyq(50.0));
  const Gains gains = design_lqr(leg, {}, kNormalisation, Form::kCompliant, 0).value();
  double last = margins(leg, gains, 0).disk;
  for (const double corner_Hz : {400.0, 200.0, 100.0, 50.0}) {
    const Margins m = margins(leg, gains, 0, {.position = {}, .velocity = low_pass(corner_Hz), .force = {}});
    EXPECT_LT(m.disk, last) << corner_Hz;
    last = m.disk;
  }
}

TEST(Margins, ALoopThatAFilterMakesUnstableHasNone) {
  const DiscreteModel leg = testing::sampled(testing::hyq(2.5));
  const Gains gains = design_lqr(leg, {}, kNormalisation, Form::kCompliant, 0).value();
  const MeasurementFilter turned{0, {-1.0}, {1.0}};
  const Margins m = margins(leg, gains, 0, {.position = {}, .velocity = {}, .force = turned});
  EXPECT_EQ(m.disk, 0.0);
}

TEST(Margins, OfTheThesissOwnSwingGainsAreAboutAFifth) {
  // The margin that its weights leave in swing on HyQ at 1 kHz. Careful engineers refuse this order (0.4 is usual).
  const DiscreteModel leg = testing::sampled(testing::hyq(2.5));
  const Gains gains = design_lqr(leg, {}, kNormalisation, Form::kCompliant, 0).value();
  const Margins m = margins(leg, gains, 0);
  RecordProperty("disk", std::to_string(m.disk));
  EXPECT_GT(m.disk, 0.1);
  EXPECT_LT(m.disk, 0.3);
}

TEST(Margins, AllocateNothing) {
  const Case c = cases().front();
  margins(c.model, c.gains, c.delay);
  const farrier::test::AllocationGuard guard;
  const Margins m = margins(c.model, c.gains, c.delay);
  const Margins filtered = margins(c.model, c.gains, c.delay, {low_pass(200.0), low_pass(200.0), low_pass(200.0)});
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_GT(m.disk + filtered.disk, 0.0);
}

}  // namespace margins_test
}  // namespace farrier::control
