// Common Lyapunov functions and dwell times, against products of the matrices themselves.

#include <gtest/gtest.h>

#include <cmath>

#include "control/numerics/common_lyapunov.hpp"
#include "control/law/force_controller.hpp"
#include "control/numerics/spectrum.hpp"
#include "control/design/switching.hpp"
#include "models.hpp"
#include "tests/support/allocation_guard.hpp"
#include "tests/support/dense_solvers.hpp"

namespace farrier::control {
namespace switching_test {

using testing::kNormalisation;

SwitchedLoop free_loop(const SmallMatrix& m) { return {m, m}; }

/// Largest spectral radius per tick of a^i b^j, periodic switching that stays from `shortest` ticks up in each.
double worst_periodic(const SwitchedLoop& a, const SwitchedLoop& b, int shortest, int longest) {
  double worst = 0.0;
  SmallMatrix stay_a = a.entry;
  for (int i = 1; i <= longest; ++i) {
    SmallMatrix stay_b = b.entry;
    for (int j = 1; j <= longest; ++j) {
      if (i >= shortest && j >= shortest) {
        const SmallMatrix cycle = stay_b * stay_a;
        worst = std::max(worst, std::pow(spectral_radius(cycle), 1.0 / (i + j)));
      }
      stay_b = (b.loop * stay_b).eval();
    }
    stay_a = (a.loop * stay_a).eval();
  }
  return worst;
}

/// Two damped turns in ellipses across each other: each decays, and alternately they grow.
SmallMatrix turn(double stretch, double angle, double decay) {
  SmallMatrix m(2, 2);
  m << std::cos(angle), -stretch * std::sin(angle), std::sin(angle) / stretch, std::cos(angle);
  return decay * m;
}

TEST(Switching, CommutingLoopsHaveACommonFunction) {
  for (int i = 0; i < 20; ++i) {
    const auto basis = testing::random_matrix<Eigen::Matrix4d>("basis", i);
    const Eigen::Vector4d p(0.9, -0.5, 0.3, 0.7), q(0.2, 0.8, -0.9, 0.6);
    const SmallMatrix a = basis * p.asDiagonal() * test::inverse(basis);
    const SmallMatrix b = basis * q.asDiagonal() * test::inverse(basis);
    const SwitchingVerdict verdict = switching_verdict(free_loop(a), free_loop(b));
    EXPECT_TRUE(verdict.common) << i;
    EXPECT_EQ(verdict.dwell_ticks, 1);
    EXPECT_LT(verdict.rate, 1.0);
    EXPECT_GE(verdict.rate, 0.9 * (1.0 - 1e-9)) << "no faster than the slower loop";
  }
}

TEST(Switching, LoopsThatGrowWhenAlternatedGetADwellTimeThatStabilisesThem) {
  const SwitchedLoop a = free_loop(turn(4.0, 0.5, 0.95));
  const SwitchedLoop b = free_loop(turn(0.25, 0.5, 0.95));
  ASSERT_LT(spectral_radius(a.loop), 1.0);
  ASSERT_GT(worst_periodic(a, b, 1, 12), 1.0) << "the counterexample is one";
  const SwitchingVerdict verdict = switching_verdict(a, b);
  EXPECT_FALSE(verdict.common);
  EXPECT_GT(verdict.dwell_ticks, 1);
  ASSERT_LT(verdict.dwell_ticks, 200);
  EXPECT_LT(worst_periodic(a, b, verdict.dwell_ticks, verdict.dwell_ticks + 20), 1.0);
  EXPECT_LE(worst_periodic(a, b, verdict.dwell_ticks, verdict.dwell_ticks + 20), verdict.rate + 1e-12);
}

TEST(Switching, OfRandomPairsIsNeverContradictedByProducts) {
  int common = 0, dwelling = 0;
  for (int i = 0; i < 60; ++i) {
    Eigen::Matrix3d a = testing::random_matrix<Eigen::Matrix3d>("la", i);
    Eigen::Matrix3d b = testing::random_matrix<Eigen::Matrix3d>("lb", i);
    a *= 0.85 / spectral_radius(a);
    b *= (0.4 + 0.01 * i) / spectral_radius(b);
    if (spectral_radius(b) >= 1.0) {
      continue;
    }
    const SwitchingVerdict verdict = switching_verdict(free_loop(a), free_loop(b));
    ASSERT_LT(verdict.dwell_ticks, kNoDwell) << i;
    EXPECT_LT(verdict.rate, 1.0);
    EXPECT_LE(worst_periodic(free_loop(a), free_loop(b), verdict.dwell_ticks, verdict.dwell_ticks + 8),
              verdict.rate + 1e-12)
        << i;
    (verdict.common ? common : dwelling) += 1;
  }
  EXPECT_GT(common, 5);
  EXPECT_GT(dwelling, 5);
}

TEST(Switching, FindsAFunctionWhereverOneWasBuiltIn) {
  // Contractions in one random norm: a common function exists, and neither loop's own says so.
  for (int i = 0; i < 20; ++i) {
    const auto t = testing::random_matrix<Eigen::Matrix4d>("norm", i);
    const auto contraction = [&](const char* name) {
      const auto m = testing::random_matrix<Eigen::Matrix4d>(name, i);
      const SmallMatrix inside = 0.95 * m / test::singular_values(m.cast<std::complex<double>>())(0);
      return SmallMatrix(t * inside * test::inverse(t));
    };
    EXPECT_TRUE(switching_verdict(free_loop(contraction("ca")), free_loop(contraction("cb"))).common) << i;
  }
}

TEST(Switching, CertificateHoldsWhatItSays) {
  const switching::Matrix6 a = 0.5 * switching::Matrix6::Identity();
  switching::Matrix6 p;
  ASSERT_TRUE(switching::find_common(std::span(&a, 1), p));
  EXPECT_TRUE(switching::is_common(p, std::span(&a, 1)));
  const switching::Matrix6 growing = 1.01 * switching::Matrix6::Identity();
  EXPECT_FALSE(switching::is_common(p, std::span(&growing, 1)));
  EXPECT_FALSE(switching::is_common(-p, std::span(&a, 1)));
}

TEST(Switching, RefusesWhatNoDwellHelps) {
  const SwitchedLoop good = free_loop(turn(1.0, 0.3, 0.9));
  EXPECT_EQ(switching_verdict(good, free_loop(turn(1.0, 0.3, 1.01))).dwell_ticks, kNoDwell) << "unstable by itself";
  SwitchedLoop broken = good;
  broken.loop(0, 0) = std::nan("");
  EXPECT_EQ(switching_verdict(good, broken).dwell_ticks, kNoDwell);
  SmallMatrix larger = SmallMatrix::Zero(3, 3);
  EXPECT_EQ(switching_verdict(good, free_loop(larger)).dwell_ticks, kNoDwell) << "of another size";
}

struct Leg {
  DiscreteModel swing = testing::sampled(testing::hyq(2.5));
  DiscreteModel stance = testing::sampled(testing::hyq(50.0));
  Gains swing_gains, stance_gains;
  explicit Leg(int delay)
      : swing_gains(design_lqr(swing, {}, kNormalisation, Form::kCompliant, delay).value()),
        stance_gains(design_lqr(stance, {}, kNormalisation, Form::kCompliant, delay).value()) {}
};

/// Command of a bumpless controller on a leg that changes plant and gains every `dwell` ticks; largest |F| of the last
/// tenth over that of the first.
double growth_of_a_run(const Leg& leg, int delay, int dwell) {
  constexpr int kTicks = 4000;
  ForceController controller;
  Eigen::Vector3d x(0.0, 0.1, 500.0);
  std::array<double, kMaxDelayTicks + 1> sent{};
  Measurement last{};
  double first = 0.0, end = 0.0;
  for (int tick = 0; tick < kTicks; ++tick) {
    const bool stance = tick / dwell % 2 == 0;
    if (tick % dwell == 0) {
      controller.set_gains(stance ? leg.stance_gains : leg.swing_gains, last, 0.0);
    }
    last = {0.0, x(1), x(2)};
    sent[2] = sent[1];
    sent[1] = sent[0];
    sent[0] = controller.step(0.0, last).valve_current_A;
    const DiscreteModel& plant = stance ? leg.stance : leg.swing;
    x = (plant.a * x + plant.b * sent[static_cast<std::size_t>(delay)]).eval();
    if (tick < kTicks / 10) {
      first = std::max(first, std::abs(x(2)));
    } else if (tick >= kTicks - kTicks / 10) {
      end = std::max(end, std::abs(x(2)));
    }
  }
  return end / first;
}

TEST(Switching, OfALegsStanceAndSwingIsStableAtItsDwell) {
  for (const int delay : {0, 1}) {
    const Leg leg(delay);
    const SwitchingVerdict verdict =
        switching_verdict(leg.stance, leg.stance_gains, leg.swing, leg.swing_gains, delay);
    RecordProperty("dwell_" + std::to_string(delay), verdict.dwell_ticks);
    ASSERT_LT(verdict.dwell_ticks, kNoDwell) << delay;
    EXPECT_LT(verdict.rate, 1.0);
    for (const int longer : {0, 1, 7, 40}) {
      EXPECT_LT(growth_of_a_run(leg, delay, verdict.dwell_ticks + longer), 1e-3) << delay << ", + " << longer;
    }
  }
}

TEST(Switching, CoordinatesOfTheCommandAreTheSameLoop) {
  const Leg leg(1);
  const SwitchedLoop loop = switched_loop(leg.stance, leg.stance_gains, 1, leg.swing);
  EXPECT_NEAR(spectral_radius(loop.loop), leg.stance_gains.spectral_radius, 1e-9);
}

TEST(Switching, RefusesGainsOfDifferentScales) {
  Leg leg(0);
  leg.swing_gains.normalisation.force *= 2.0;
  EXPECT_EQ(switching_verdict(leg.stance, leg.stance_gains, leg.swing, leg.swing_gains, 0).dwell_ticks, kNoDwell);
}

TEST(Switching, AllocatesNothing) {
  const Leg leg(1);
  const farrier::test::AllocationGuard guard;
  const SwitchingVerdict verdict = switching_verdict(leg.stance, leg.stance_gains, leg.swing, leg.swing_gains, 1);
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_GT(verdict.dwell_ticks, 0);
}

}  // namespace switching_test
}  // namespace farrier::control
