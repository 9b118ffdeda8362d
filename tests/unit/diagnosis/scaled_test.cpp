// Recordings in scaled units: what hides in the valve is found, and what does not is not.

#include <gtest/gtest.h>

#include "diagnosis/judge/scaled_diagnosis.hpp"
#include "diagnosis/model/scaled_simulator.hpp"
#include "scaled.hpp"

namespace farrier::diagnosis {
namespace scaled_test {

using testing::arm;
using testing::kDrift;
using testing::kGain;

plant::EffectId id_of(const char* name) { return plant::find_effect(name); }

/// First number of an effect in the recording's units.
double value_of_first(const ScaledDiagnosis& d, const NamedEffect& effect) {
  return d.scales.value(plant::effect_info(effect.id).parameters[0], effect.fitted[0]);
}

const EffectAlone& alone(const ScaledDiagnosis& d, const char* name) {
  return *std::ranges::find(d.alone, id_of(name), &EffectAlone::id);
}

TEST(ScaledDiagnosis, ALinearArmLacksNothing) {
  const ScaledDiagnosis d = diagnose_scaled(arm([](double opening) { return opening; }));
  EXPECT_EQ(d.judgement.verdict, Verdict::kNone);
  EXPECT_TRUE(d.judgement.effects.empty());
  EXPECT_NEAR(d.gain_before, kGain, 0.01 * std::abs(kGain));
  EXPECT_NEAR(d.drift_before, kDrift, 0.01 * std::abs(kDrift));
  EXPECT_GT(d.fit_before_percent, 98.0);
}

TEST(ScaledDiagnosis, NoiseIsNoEffectAndHidesNone) {
  constexpr double kNoise = 0.003;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const ScaledDiagnosis linear = diagnose_scaled(arm([](double opening) { return opening; }, seed, kNoise));
    EXPECT_EQ(linear.judgement.verdict, Verdict::kNone) << seed;
    const ScaledDiagnosis bent =
        diagnose_scaled(arm([](double opening) { return testing::saturated(opening, 0.5); }, seed, kNoise));
    ASSERT_EQ(bent.judgement.verdict, Verdict::kEffects) << seed;
    EXPECT_EQ(bent.judgement.effects[0].id, id_of("flow_saturation")) << seed;
    EXPECT_NEAR(value_of_first(bent, bent.judgement.effects[0]), 0.5, 0.02) << seed;
  }
}

TEST(ScaledDiagnosis, AnOffsetOfALinearValveIsADriftAndNoEffect) {
  const ScaledDiagnosis d = diagnose_scaled(arm([](double opening) { return opening + 0.1; }));
  EXPECT_EQ(d.judgement.verdict, Verdict::kNone);
  EXPECT_NEAR(d.drift_before, kDrift + 0.1 * kGain, 0.01 * std::abs(kDrift));
  EXPECT_NE(std::ranges::find(d.judgement.not_judged, id_of("valve_bias")), d.judgement.not_judged.end());
}

TEST(ScaledDiagnosis, AnOffsetBeforeAFlowThatSaturatesIsNamedBesideIt) {
  constexpr double kOffset = 0.1;
  const ScaledDiagnosis d =
      diagnose_scaled(arm([](double opening) { return testing::saturated(opening + kOffset, 0.45); }));
  ASSERT_EQ(d.judgement.verdict, Verdict::kEffects);
  ASSERT_EQ(d.judgement.effects.size(), 2u);
  const auto bias = std::ranges::find(d.judgement.effects, id_of("valve_bias"), &NamedEffect::id);
  ASSERT_NE(bias, d.judgement.effects.end());
  EXPECT_NEAR(value_of_first(d, *bias), kOffset, 0.1 * kOffset);
  EXPECT_EQ(std::ranges::find(d.judgement.not_judged, id_of("valve_bias")), d.judgement.not_judged.end());
}

TEST(ScaledDiagnosis, AFlowThatSaturatesIsNamedWithItsSize) {
  constexpr double kAt = 0.45;
  const ScaledDiagnosis d = diagnose_scaled(arm([](double opening) { return testing::saturated(opening, kAt); }));
  ASSERT_EQ(d.judgement.verdict, Verdict::kEffects);
  ASSERT_EQ(d.judgement.effects.size(), 1u);
  EXPECT_EQ(d.judgement.effects[0].id, id_of("flow_saturation"));
  EXPECT_NEAR(value_of_first(d, d.judgement.effects[0]), kAt, 0.02 * kAt);
  EXPECT_NEAR(d.gain_after, kGain, 0.02 * std::abs(kGain));
  EXPECT_GT(d.fit_after_percent, 98.0);
  EXPECT_LT(d.fit_before_percent, 80.0);
  EXPECT_FALSE(alone(d, "valve_deadband").accepted);
  EXPECT_NEAR(alone(d, "valve_deadband").fitted[0], 0.0, 1e-6);
}

TEST(ScaledDiagnosis, AnOverlapOfTheSpoolIsNamedWithItsWidth) {
  constexpr double kHalfWidth = 0.15;
  const ScaledDiagnosis d =
      diagnose_scaled(arm([](double opening) { return testing::overlapped(opening, kHalfWidth); }));
  ASSERT_EQ(d.judgement.verdict, Verdict::kEffects);
  EXPECT_EQ(d.judgement.effects[0].id, id_of("valve_deadband"));
  EXPECT_NEAR(value_of_first(d, d.judgement.effects[0]), kHalfWidth, 0.03 * kHalfWidth);
  EXPECT_GT(d.fit_after_percent, 98.0);
}

TEST(ScaledDiagnosis, UnlikePortsAreNamedWithTheirRatio) {
  const ScaledDiagnosis d =
      diagnose_scaled(arm([](double opening) { return opening * (opening > 0.0 ? 1.3 : 0.7); }));
  ASSERT_EQ(d.judgement.verdict, Verdict::kEffects);
  EXPECT_EQ(d.judgement.effects[0].id, id_of("valve_asymmetry"));
  EXPECT_NEAR(d.judgement.effects[0].fitted[0], 0.3, 0.01);
}

TEST(ScaledDiagnosis, ADelayIsNamedInSamples) {
  std::vector<double> late(5, 0.0);
  const ScaledDiagnosis d = diagnose_scaled(arm([&](double opening) {
    late.push_back(opening);
    return late[late.size() - 5];  // four samples
  }));
  ASSERT_FALSE(d.judgement.effects.empty());
  EXPECT_EQ(d.judgement.effects[0].id, id_of("input_delay"));
  EXPECT_NEAR(d.judgement.effects[0].fitted[0] / ScaledSimulator::kSample_s, 4.0, 0.1);
}

TEST(ScaledDiagnosis, WhatNoEffectOfTheValveMakesIsUnknown) {
  double sum = 0.0;
  const ScaledDiagnosis d = diagnose_scaled(arm([&](double opening) {
    sum += opening;
    return opening * std::cos(0.3 * sum);
  }));
  EXPECT_EQ(d.judgement.verdict, Verdict::kUnknown);
}

TEST(ScaledSimulator, DerivativesAreThoseOfFiniteDifferences) {
  const ScaledRecording recording = arm([](double opening) { return testing::saturated(opening, 0.5); });
  const ScaledSimulator simulator(recording);
  const Span all{0, simulator.size()};
  for (plant::EffectId id = 0; id < plant::kEffectCount; ++id) {
    for (auto start : simulator.starts(id)) {
      start[0] *= 1.03;  // a delay of whole samples has two slopes
      Model middle = simulator.nominal();
      middle.effects = {{id, start}};
      const auto free = simulator.free_numbers(middle, {true, false, false}, 0.0);
      std::vector<std::size_t> lanes;
      for (const FreeNumber& number : free) {
        lanes.push_back(number.place);
      }
      std::vector<double> jacobian;
      const auto value = simulator.simulate_lanes(all, middle, ScaledSimulator::kChannel, {}, lanes, jacobian);
      EXPECT_NEAR(value.back(), simulator.simulate(all, middle, ScaledSimulator::kChannel, {}).back(), 1e-9);
      const double step = 1e-6 * start[0];
      Model above = middle;
      Model below = middle;
      above.effects[0].fitted[0] += step;
      below.effects[0].fitted[0] -= step;
      const auto high = simulator.simulate(all, above, ScaledSimulator::kChannel, {});
      const auto low = simulator.simulate(all, below, ScaledSimulator::kChannel, {});
      double error = 0.0;
      double size = 1e-30;
      for (std::size_t i = 0; i < value.size(); ++i) {
        const double slope = (high[i] - low[i]) / (2.0 * step);
        const double derivative = jacobian[i * lanes.size() + 2];
        error += (slope - derivative) * (slope - derivative);
        size += slope * slope;
      }
      EXPECT_LT(std::sqrt(error / size), 1e-3) << plant::effect_info(id).name;
    }
  }
}

TEST(FitPercent, IsHundredForTheTruthAndNoneForItsMean) {
  const std::vector<double> truth{1.0, 2.0, 3.0};
  EXPECT_DOUBLE_EQ(fit_percent(truth, truth), 100.0);
  EXPECT_DOUBLE_EQ(fit_percent(truth, std::vector<double>(3, 2.0)), 0.0);
  EXPECT_LT(fit_percent(truth, std::vector<double>(3, 10.0)), -100.0);
}

}  // namespace scaled_test
}  // namespace farrier::diagnosis
