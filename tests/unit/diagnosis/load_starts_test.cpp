// Where fits of a load's friction that swings with the position, and of its spring, begin and where they end.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/noise.hpp"
#include "diagnosis/judge/fit.hpp"
#include "diagnosis/model/load_starts.hpp"
#include "diagnosis/model/joint_simulator.hpp"
#include "tests/unit/diagnosis/rig.hpp"

namespace farrier::diagnosis {
namespace load_starts_test {

constexpr plant::EffectId kWavy = plant::effect_id<plant::PositionDependentFriction>();

/// Numbers of the effect, as a fit has them: mean friction, waviness, wavelength and a tightest place.
struct Wave {
  double coulomb, waviness, wavelength, tightest;
};
Wave wave_of(const std::vector<double>& fitted) { return {fitted[0], fitted[5], fitted[6], fitted[7]}; }

constexpr Wave kHidden{0.03, 0.6, 0.09, 0.52};

std::vector<double> numbers(const Wave& wave) {
  return {wave.coulomb, 1.3, 0.01, 4.0 * plant::kPreslidingShare, 0.0, wave.waviness, wave.wavelength, wave.tightest};
}

/// The rig with a hidden effect, under random steps of the current.
JointData recorded_with(plant::EffectId hidden, const std::vector<double>& fitted, double duration_s) {
  const NoiseStream draw(7, "load_starts_test", "current");
  const plant::Scales scales(rig().actuator, rig().swing_load);
  const Recording recording = recorded_rig(static_cast<int>(1000.0 * duration_s), rig().swing_load,
                                           [&](int k) { return (2.0 * draw.uniform(k / 60) - 1.0) * 2e-3; },
                                           {plant::active_effect(hidden, fitted, scales)});
  return prepare(recording, rig().actuator, rig().noise.position);
}

/// The rig on a guide that is tight in places.
JointData recorded(double duration_s) { return recorded_with(kWavy, numbers(kHidden), duration_s); }

void expect_near_hidden(const Wave& wave, double share) {
  EXPECT_NEAR(wave.coulomb, kHidden.coulomb, share * kHidden.coulomb);
  EXPECT_NEAR(wave.waviness, kHidden.waviness, share * kHidden.waviness);
  EXPECT_NEAR(wave.wavelength, kHidden.wavelength, share * kHidden.wavelength);
  const double waves = (wave.tightest - kHidden.tightest) / kHidden.wavelength;
  EXPECT_NEAR(waves, std::round(waves), share);
}

TEST(FrictionStarts, LieNearTheWaveThatTheRecordingHas) {
  const JointModel model(rig().actuator, rig().swing_load);
  const auto starts = model.starts(kWavy, recorded(4.0));
  ASSERT_FALSE(starts.empty());
  expect_near_hidden(wave_of(starts.front()), 0.3);
}

TEST(FrictionStarts, LeadAFitToTheHiddenWave) {
  const JointData data = recorded(4.0);
  const JointModel model(rig().actuator, rig().swing_load);
  const JointSimulator simulator(model, data);
  const FitData fitted{&simulator, {false, true, false}, {1.0, 1e-3, 1.0}};
  Model start = Model::nominal();
  start.effects = {{kWavy, simulator.starts(kWavy).front()}};
  FitOptions options;
  options.most_iterations = 60;  // to its end
  options.tolerance = 1e-6;
  const FitResult result = fit(fitted, {0, data.size()}, start, {false, true, false}, options);
  expect_near_hidden(wave_of(result.model.effects[0].fitted), 0.05);
}

TEST(FrictionStarts, OfARecordingThatIsTooShortAreTheLibrarys) {
  const plant::Scales scales(rig().actuator, rig().swing_load);
  EXPECT_EQ(starts_of_friction_wave(recorded(0.1), scales), starts_of(plant::effect_info(kWavy)));
}

TEST(HardeningStarts, LieNearTheSpringThatTheRecordingHas) {
  constexpr plant::EffectId kHardens = plant::effect_id<plant::SpringHardening>();
  const JointModel model(rig().actuator, rig().swing_load);
  const std::vector<double> hidden{60.0, 0.3};
  const std::vector<double> start = model.starts(kHardens, recorded_with(kHardens, hidden, 4.0)).back();
  EXPECT_NEAR(start[0], hidden[0], 0.3 * hidden[0]);
  EXPECT_NEAR(start[1], hidden[1], 0.1);
}

TEST(HardeningStarts, OfARecordingWithoutAWayOfTheLoadAreTheUsualOnes) {
  const plant::Scales scales(rig().actuator, rig().swing_load);
  EXPECT_TRUE(starts_of_hardening(recorded(0.1), scales).empty()) << "too short";
  JointData data = recorded(1.0);
  data.swing.assign(data.size(), 0);
  EXPECT_TRUE(starts_of_hardening(data, scales).empty()) << "never the load of the model";
  data.swing.clear();
  std::ranges::fill(data.position, 0.04);
  EXPECT_TRUE(starts_of_hardening(data, scales).empty()) << "does not move";
}

}  // namespace load_starts_test
}  // namespace farrier::diagnosis
