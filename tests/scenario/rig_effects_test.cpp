#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "thesis/rig/filter_study.hpp"
#include "thesis/rig/force_step.hpp"
#include "thesis/rig/rig_run.hpp"

namespace farrier::thesis {
namespace rig_effects_test {

robot::Robot load(const char* name) { return robot::load_robot(std::string(FARRIER_ROBOTS) + name + ".yaml").value(); }

// Hubacher (2014), 10.2: a velocity filter's lag costs tracking of the light load, whose loop is fast; 10.3:
// oversampling behind an anti-aliasing filter gives the heavy load's large force gain less noise to act on.
TEST(FilterStudy, ShowsWhatLagCostsAndWhatOversamplingGives) {
  const auto study = filter_study(load("fc1d"), {{0.0, 2, false}, {50.0, 2, false}, {0.0, 2, true}}, 1.0);
  ASSERT_TRUE(study.ok()) << (study ? "" : study.error().message);
  const std::vector<FilterRow>& rows = study.value();
  ASSERT_EQ(rows.size(), 6u);
  const FilterRow &light = rows[0], &heavy = rows[1], &light_filtered = rows[2], &heavy_oversampled = rows[5];
  EXPECT_EQ(light.load_mass_kg, 2.5);
  EXPECT_EQ(heavy.load_mass_kg, 50.0);
  EXPECT_GT(light_filtered.nrmse, 1.3 * light.nrmse);
  EXPECT_LT(heavy_oversampled.nrmse, 0.85 * heavy.nrmse);
  EXPECT_LT(heavy_oversampled.current_step_rms_A, 0.7 * heavy.current_step_rms_A);
  for (const FilterRow& row : rows) {
    EXPECT_TRUE(row.stayed_armed);
    EXPECT_GT(row.nrmse, 0.0);
    EXPECT_NE(row.gains.generation, 0u);
    EXPECT_EQ(row.velocity_filter.b[0] == 1.0, row.filter.velocity_cut_off_Hz == 0.0);
    EXPECT_EQ(row.conversion_delay_ticks, row.filter.oversampled ? 0.4375 : 0.0);
  }
}

TEST(FilterStudy, GivesTheSameRowsAgain) {
  const auto one = filter_study(load("fc1d"), {{100.0, 2, true}}, 0.5);
  const auto other = filter_study(load("fc1d"), {{100.0, 2, true}}, 0.5);
  ASSERT_TRUE(one.ok() && other.ok());
  EXPECT_EQ(one.value()[0].nrmse, other.value()[0].nrmse);
  EXPECT_EQ(one.value()[1].current_step_rms_A, other.value()[1].current_step_rms_A);
}

TEST(FilterStudy, RefusesWhatItCannotRunWithTheReason) {
  const auto hyq = filter_study(load("hyq"), filter_cases());
  ASSERT_FALSE(hyq);
  EXPECT_NE(hyq.error().message.find("one joint and a multisine"), std::string::npos);
  const auto fast = filter_study(load("fc1d"), {{480.0, 2, false}});
  ASSERT_FALSE(fast);
  EXPECT_NE(fast.error().message.find("within 450 Hz"), std::string::npos) << fast.error().message;
  EXPECT_FALSE(filter_study(load("fc1d"), filter_cases(), 0.1));
}

/// The rig with the velocity alone filtered, at 100 Hz, and a cart that sticks more: its loop has no margin at the mode of
/// the load on the oil. Behind the filters of the file that mode is quiet.
robot::Robot oscillating_rig() {
  robot::Robot rig = load("fc1d_real");
  robot::Joint& joint = rig.joints[0];
  joint.noise = {};
  joint.sensors.position.cut_off_Hz = joint.sensors.force.cut_off_Hz = 0.0;
  joint.sensors.velocity.cut_off_Hz = 100.0;
  for (plant::ActiveEffect& effect : joint.effects) {
    if (effect.id == plant::effect_id<plant::LoadFriction>()) {
      effect.values[0] = 40.0;  // coulomb_N
      effect.values[1] = 1.5;   // breakaway_ratio
    }
  }
  return rig;
}

constexpr ForceStep kSlowStep{.to_N = 400.0, .begin_s = 0.05, .rise_s = 0.1, .duration_s = 0.2};

double ring_Pa(const robot::Robot& rig) {
  const auto samples = run_force_step(rig, kSlowStep);
  EXPECT_TRUE(samples.ok()) << (samples ? "" : samples.error().message);
  return samples ? load_pressure_oscillation(samples.value(), 0.125, 0.15).peak_Pa : 0.0;
}

// Hubacher (2014), 9.4 and Fig. 9.23; docs/derivations/load-pressure-oscillation.md. The valve command is smooth, the
// piston breaks away, and only then the load pressure swings. Without the line, or without the velocity filter, less
// than a tenth of it is left while the reference still rises.
TEST(ForceStep, OfARigThatSticksMakesTheLoadPressureSwingWhenThePistonBreaksAway) {
  const robot::Robot rig = oscillating_rig();
  const auto run = run_force_step(rig, kSlowStep);
  ASSERT_TRUE(run.ok()) << run.error().message;
  const Oscillation stuck = load_pressure_oscillation(run.value(), 0.058, 0.066);
  const Oscillation moving = load_pressure_oscillation(run.value(), 0.1, 0.15);
  EXPECT_GT(moving.peak_Pa, 5.0 * stuck.peak_Pa);
  EXPECT_GT(moving.frequency_Hz, 150.0);
  EXPECT_LT(moving.frequency_Hz, 220.0);
  robot::Robot without_line = rig;
  without_line.joints[0].actuator.line.length_m = 0.0;
  EXPECT_LT(ring_Pa(without_line), 0.1 * ring_Pa(rig));
  robot::Robot without_filter = rig;
  without_filter.joints[0].sensors.velocity.cut_off_Hz = 0.0;
  EXPECT_LT(ring_Pa(without_filter), 0.1 * ring_Pa(rig));
}

TEST(ForceStep, OfTheIdealRigSettlesOnItsReference) {
  robot::Robot rig = load("fc1d");
  rig.joints[0].noise = {};
  const auto run = run_force_step(rig, {.to_N = 200.0, .duration_s = 0.4});
  ASSERT_TRUE(run.ok()) << run.error().message;
  EXPECT_EQ(run.value().size(), 400u * 20u);
  EXPECT_EQ(run.value().front().reference_N, 0.0);
  EXPECT_NEAR(run.value().back().force_N, 200.0, 2.0);
}

TEST(ForceStep, IsRefusedWithTheReasonWhereItCannotBe) {
  EXPECT_FALSE(run_force_step(load("hyq"), {}));
  EXPECT_FALSE(run_force_step(load("fc1d"), {.begin_s = 0.5, .duration_s = 0.3}));
  const auto far = run_force_step(load("fc1d"), {.from_N = 2000.0});
  ASSERT_FALSE(far);
  EXPECT_NE(far.error().message.find("give a smaller first force"), std::string::npos);
}

TEST(LoadPressureOscillation, FindsFrequencyAndDecayOfATone) {
  constexpr double kSample_s = 5e-5;
  std::vector<ForceStepSample> tone(4000);
  for (std::size_t i = 0; i < tone.size(); ++i) {
    const double t = static_cast<double>(i) * kSample_s;
    tone[i].time_s = t;
    tone[i].load_pressure_Pa =
        20e5 +
        (t < 0.05 ? 0.0 : 1e5 * std::exp(-(t - 0.05) / 0.01) * std::sin(2.0 * std::numbers::pi * 300.0 * (t - 0.05)));
  }
  const Oscillation found = load_pressure_oscillation(tone, 0.02, 0.18);
  EXPECT_NEAR(found.frequency_Hz, 300.0, 10.0);
  EXPECT_NEAR(found.decay_s, 0.01 * std::log(10.0), 2.0 / 300.0);  // read at half swings
  EXPECT_NEAR(found.begin_s, 0.05, 0.5 * 0.01);  // the centred mean sees what begins half a window ahead
}

}  // namespace rig_effects_test
}  // namespace farrier::thesis
