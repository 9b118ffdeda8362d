// Which effects a recording cannot show.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/diagnosis.hpp"
#include "plant/hydraulic_joint.hpp"
#include "robot/robot.hpp"

namespace farrier::diagnosis {
namespace {

const robot::Joint& rig() {
  static const robot::Robot robot = robot::load_robot(FARRIER_ROBOTS "fc1d.yaml").value();
  return robot.joints.front();
}

/// The rig under a slow sine of the current, without noise.
Recording slow_sine(double amplitude_A) {
  auto joint = plant::HydraulicJoint::create(rig().actuator, rig().swing_load,
                                             plant::equilibrium(rig().actuator, rig().swing_load, 0.04, 0.0))
                   .value();
  Recording recording;
  recording.period_s = 0.001;
  for (int k = 0; k < 3000; ++k) {
    const double current = amplitude_A * std::sin(2.0 * k * 1e-3) - 0.05 * (joint.state().position - 0.04);
    recording.valve_current_A.push_back(current);
    recording.position.push_back(joint.state().position);
    recording.velocity.push_back(joint.state().velocity);
    recording.force.push_back(joint.load_cell_force());
    joint.step(current, 0.0, recording.period_s);
  }
  return recording;
}

std::vector<std::string> not_judged_in(const Recording& recording) {
  std::vector<std::string> names;
  for (const plant::EffectId id : diagnose(recording, rig()).judgement.not_judged) {
    names.emplace_back(plant::effect_info(id).name);
  }
  return names;
}

bool lists(const std::vector<std::string>& names, const char* name) {
  return std::ranges::find(names, name) != names.end();
}

TEST(NotJudged, EffectsOfTheValveAreInARecordingWithoutItsCurrent) {
  Recording recording = slow_sine(1e-3);
  recording.valve_current_A.clear();
  const auto names = not_judged_in(recording);
  EXPECT_TRUE(lists(names, "valve_deadband"));
  EXPECT_TRUE(lists(names, "supply_droop"));
  EXPECT_FALSE(lists(names, "load_friction"));
  EXPECT_FALSE(lists(names, "force_sensor_offset"));
}

TEST(NotJudged, AVelocityThatWasDerivedSaysNothingOfItsSensor) {
  Recording recording = slow_sine(1e-3);
  recording.velocity_derived = true;
  recording.derived_velocity_noise = rig().noise.velocity;
  EXPECT_TRUE(lists(not_judged_in(recording), "velocity_filter_lag"));
}

TEST(NotJudged, ASlowMotionDoesNotShowALagOfTheVelocitySensorButABiasOfTheValve) {
  const auto names = not_judged_in(slow_sine(0.3e-3));
  EXPECT_TRUE(lists(names, "velocity_filter_lag"));
  EXPECT_FALSE(lists(names, "valve_bias"));
}

}  // namespace
}  // namespace farrier::diagnosis
