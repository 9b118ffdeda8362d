// Parts of the compensation of effects, each against the plant's own term, which it knows nothing of but its numbers.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "control/law/droop_inverse.hpp"
#include "control/law/lag_lead.hpp"
#include "control/law/spool_lead.hpp"
#include "control/law/valve_opening.hpp"
#include "plant/hydraulic_joint.hpp"
#include "tests/unit/control/effects.hpp"

namespace farrier::control {
namespace effect_inverses_test {

/// Ticks by which a spool's mean opening stays behind a step, with the currents of `next`.
template <class Next>
double lag_ticks(const ActiveEffect& spool, Next next) {
  plant::TermSet<double> terms = terms_of({spool});
  constexpr double kAsked_A = 1e-4;
  double missing = 0.0;
  for (int k = 0; k < 200; ++k) {
    missing += 1.0 - opening_A(terms, next(kAsked_A)) / kAsked_A;
  }
  return missing;
}

TEST(SpoolLead, MakesTheSpoolFollowSoonerAndKnowsByHowMuch) {
  for (const double rate_rad_s : {190.0, 300.0, 700.0}) {
    ActiveEffect spool = kSpool;
    spool.values[0] = rate_rad_s;
    const double alone = lag_ticks(spool, [](double asked_A) { return asked_A; });
    EXPECT_NEAR(alone, 2.0 * 0.7 / rate_rad_s / kPeriod_s, 0.1) << "2 D / w";
    SpoolLead lead(rate_rad_s, 0.7, kMost_A, kPeriod_s);
    const double led = lag_ticks(spool, [&lead](double asked_A) { return lead.take(asked_A); });
    EXPECT_LT(led, 0.75 * alone) << rate_rad_s;
    EXPECT_NEAR(led, lead.lag_ticks(), 1e-9) << rate_rad_s;
  }
}

TEST(SpoolLead, AsksForNoMoreThanItsBoundOnceAndForNoneOfItInTheEnd) {
  for (const double rate_rad_s : {50.0, 190.0, 300.0, 700.0, 5000.0}) {
    SpoolLead lead(rate_rad_s, 0.7, 1.0, kPeriod_s);
    const double first_A = lead.take(1e-3);
    EXPECT_LE(first_A, 1.001e-3 * SpoolLead::kMostLead) << rate_rad_s;
    EXPECT_GE(first_A, 1e-3) << rate_rad_s;
    for (int k = 0; k < 400; ++k) {
      lead.take(1e-3);
    }
    EXPECT_NEAR(lead.take(1e-3), 1e-3, 1e-6) << rate_rad_s;
  }
}

TEST(LagLead, TakesALagBackButForItsRest) {
  plant::FirstOrderLag<double> lag(kCellLag.values[0], kPeriod_s);
  LagLead lead(kCellLag.values[0], 8.0, 0.5 * kPeriod_s, kPeriod_s);
  EXPECT_EQ(lead.rest_s(), 0.5 * kPeriod_s);
  constexpr double kRate_N_s = 1000.0;
  for (int k = 0; k < 300; ++k) {
    const double time_s = k * kPeriod_s;
    const double taken = lead.take(lag.take(kRate_N_s * time_s));
    if (time_s > 10.0 * kCellLag.values[0]) {
      ASSERT_NEAR(taken, kRate_N_s * (time_s - lead.rest_s()), 1e-3);
    }
  }
}

TEST(LagLead, MakesNoMoreOfNoiseThanItsBound) {
  for (const double bound : {2.0, 4.0, 8.0}) {
    LagLead lead(0.01, bound, 1e-5, kPeriod_s);
    std::mt19937_64 random(3);
    std::normal_distribution<double> draw;
    double squares = 0.0;
    constexpr int kSamples = 20'000;
    for (int k = 0; k < kSamples; ++k) {
      const double out = lead.take(draw(random));
      squares += out * out;
    }
    EXPECT_LE(std::sqrt(squares / kSamples), 1.02 * bound);
  }
}

TEST(ValveOpening, IsThatOfThePlantsOwnTerms) {
  const std::vector<ActiveEffect> effects{{effect_id<plant::ValveBias>(), {4e-4}},
                                          {effect_id<plant::ValveDeadband>(), {2e-4}},
                                          {effect_id<plant::ValveAsymmetry>(), {0.2}},
                                          {effect_id<plant::FlowSaturation>(), {6e-3}}};
  plant::TermSet<double> terms = terms_of(effects);
  const ValveOpening valve(effects, kActuator);
  for (double current_A = -kMost_A; current_A <= kMost_A; current_A += 1.3e-4) {
    EXPECT_NEAR(valve.at(current_A), opening_A(terms, current_A), 1e-15) << current_A;
    EXPECT_EQ(ValveOpening(std::vector<ActiveEffect>{kSpool}, kActuator).at(current_A), current_A);
  }
}

// Pressures in balance at a supply that falls: the plant's own steady speed against a free load.
TEST(DroopInverse, PassesAsMuchOilAsAStiffSupplyWould) {
  constexpr double kResistance_Pa_s_m3 = 1e11;
  const ActiveEffect droop{effect_id<plant::SupplyDroop>(), {kResistance_Pa_s_m3}};
  const plant::LoadParams load{.mass = 5.0, .damping = 300.0};
  const DroopInverse inverse(kResistance_Pa_s_m3, kActuator);
  const auto speed_at = [&](double current_A, std::vector<ActiveEffect> effects) {
    const double start = current_A > 0.0 ? 0.2 : 0.8;
    auto joint = plant::HydraulicJoint::create(
        kActuator, load, plant::equilibrium(kActuator, load, start * kActuator.stroke, 0.0), 1e-6, effects);
    for (int k = 0; k < 60; ++k) {
      joint.value().step(current_A, 0.0, kPeriod_s);
    }
    return std::pair(joint.value().state().velocity, joint.value().load_cell_force());
  };
  for (const double asked_A : {-2e-3, -1e-3, 1e-3, 2e-3}) {
    const auto [stiff, force] = speed_at(asked_A, {});
    const double led_A = inverse.opening_A(asked_A, {0.0, stiff, force});
    EXPECT_LT(std::abs(speed_at(asked_A, {droop}).first), 0.98 * std::abs(stiff)) << asked_A;
    EXPECT_NEAR(speed_at(led_A, {droop}).first, stiff, 0.01 * std::abs(stiff)) << asked_A;
  }
  EXPECT_LE(inverse.opening_A(1.0, {0.0, 0.0, 1e6}), DroopInverse::kMostGain);
  EXPECT_EQ(DroopInverse().opening_A(3e-3, {0.0, 1.0, 500.0}), 3e-3);
}

}  // namespace effect_inverses_test
}  // namespace farrier::control
