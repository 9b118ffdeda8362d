#include "thesis/rig/chirp_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "thesis/rig/rig_conditions.hpp"

namespace farrier::thesis {
namespace studies_chirp_figures_test {

constexpr double kPeriod_s = 1e-3;

/// A force that answers a current by a pair of poles at `frequency_Hz` and a real one that is fast.
control::DiscreteModel resonant(double frequency_Hz, double damping) {
  const double w = 2.0 * std::numbers::pi * frequency_Hz * kPeriod_s;
  const double radius = std::exp(-damping * w);
  const double angle = w * std::sqrt(1.0 - damping * damping);
  control::DiscreteModel model;
  model.a << 0.1, 0.0, 0.0,                                      //
      0.0, radius * std::cos(angle), -radius * std::sin(angle),  //
      0.0, radius * std::sin(angle), radius * std::cos(angle);
  model.b << 0.0, 1.0, 0.0;
  return model;
}

ChirpEstimates run_of(std::vector<control::DiscreteModel> models) {
  ChirpEstimates run;
  run.period_s = kPeriod_s;
  run.nominal = resonant(100.0, 0.3);
  run.first = resonant(3.0, 0.05);
  run.models = std::move(models);
  for (std::size_t i = 0; i < run.models.size(); ++i) {
    run.time_s.push_back(kModel_s * static_cast<double>(i + 1));
  }
  return run;
}

TEST(FictivePeak, IsAResonanceBelowTenHertzThatStandsOut) {
  EXPECT_TRUE(has_fictive_peak(resonant(3.0, 0.05), kPeriod_s));
  EXPECT_FALSE(has_fictive_peak(resonant(3.0, 0.9), kPeriod_s)) << "damped";
  EXPECT_FALSE(has_fictive_peak(resonant(100.0, 0.05), kPeriod_s)) << "the rig's own";
}

TEST(FictivePeak, SharesAreOfTheModelsBetweenTwoTimes) {
  const control::DiscreteModel with = resonant(3.0, 0.05);
  const control::DiscreteModel without = resonant(100.0, 0.3);
  const ChirpEstimates run = run_of({with, without, without, without});
  EXPECT_DOUBLE_EQ(fictive_share(run, 0.0, 1.0), 0.25);
  EXPECT_DOUBLE_EQ(fictive_share(run, 0.03, 1.0), 0.0);
}

TEST(Distance, IsZeroToTheModelItselfAndThatOfAFactorInDecibels) {
  control::DiscreteModel doubled = resonant(100.0, 0.3);
  doubled.b *= 2.0;
  const ChirpEstimates run = run_of({resonant(100.0, 0.3), doubled, doubled});
  EXPECT_NEAR(distance_dB(run, 0.0, 0.03), 0.0, 1e-12);
  EXPECT_NEAR(distance_dB(run, 0.03, 1.0), 20.0 * std::log10(2.0), 1e-9);
  EXPECT_NEAR(roughness_dB(run, 0.0, 1.0), 0.5 * 20.0 * std::log10(2.0), 1e-9) << "one change in two steps";
  EXPECT_GT(first_distance_dB(run), 3.0);
}

TEST(OpenSpans, LeaveOutWhatIsTooShort) {
  ChirpEstimates run;
  run.open = {true, false, true, true, true, false, true};
  const std::vector<Span> all = open_spans(run);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[1].begin, 2u);
  EXPECT_EQ(all[1].end, 5u);
  EXPECT_EQ(all[2].end, 7u);
  EXPECT_EQ(open_spans(run, 2).size(), 1u);
}

TEST(ChirpSettings, LimitsGrowWithTheSignals) {
  const auto small = params_of({.amplitude = 0.1});
  const auto large = params_of({.amplitude = 0.2});
  EXPECT_NEAR(large.pe->information_max / small.pe->information_max, 4.0, 1e-12);
  EXPECT_NEAR(large.pe->information_min / small.pe->information_min, 4.0, 1e-12);
  EXPECT_NEAR(large.fft->magnitude_min / small.fft->magnitude_min, 2.0, 1e-12);
}

robot::Robot rig_under(Condition condition) {
  StudyContext context;
  context.robots = FARRIER_ROBOTS;
  return under(condition, load_rig(context).value());
}

TEST(RigConditions, ChangeWhatTheyAreCalled) {
  const robot::Joint perfect = rig_under(Condition::kPerfectMeasurements).joints[0];
  EXPECT_EQ(perfect.noise.force, 0.0);
  EXPECT_EQ(perfect.sensors.force.cut_off_Hz, 0.0);
  EXPECT_NEAR(rig_under(Condition::kDataSheetValve).joints[0].actuator.valve_gain, 6.6815e-6, 1e-9) << "Table A.1";
  const robot::Joint viscous = rig_under(Condition::kViscousFriction).joints[0];
  EXPECT_EQ(plant::find(viscous.effects, plant::effect_id<plant::LoadFriction>()), nullptr);
  EXPECT_NE(plant::find(viscous.effects, plant::effect_id<plant::ValveDeadband>()), nullptr);
}

TEST(RigConditions, GiveEachClaimItsValueUnderItsOwnCondition) {
  constexpr ClaimSpec kClaims[] = {
      {"9.99.as_it_is", "9", "words", "what", "1", Relation::kAtMost, 1.0},
      needs(Condition::kViscousFriction, {"9.99.dry", "9", "words", "what", "1", Relation::kAtMost, 1.0})};
  StudyContext context;
  context.robots = FARRIER_ROBOTS;
  const auto count_effects = [](const robot::Robot& rig) -> Result<StudyResult> {
    const auto count = static_cast<double>(rig.joints[0].effects.size());
    return StudyResult{{{"9.99.as_it_is", count, ""}, {"9.99.dry", count, ""}}, {}};
  };
  const StudyResult result = measure_on(load_rig(context).value(), kClaims, count_effects).value();
  EXPECT_EQ(result.measured[0].under_condition, std::nullopt);
  EXPECT_EQ(result.measured[1].value, 3.0);
  EXPECT_EQ(result.measured[1].under_condition, 2.0);
}

}  // namespace studies_chirp_figures_test
}  // namespace farrier::thesis
