// Simulations of the two sides of an electric joint: against the whole joint's integrator, closed forms and differences.

#include <gtest/gtest.h>

#include <cmath>

#include "core/noise.hpp"
#include "diagnosis/model/electric_model.hpp"
#include "diagnosis/model/electric_starts.hpp"
#include "diagnosis/model/joint_simulator.hpp"
#include "plant/electric_joint.hpp"
#include "tests/unit/diagnosis/derivatives.hpp"
#include "tests/unit/robot/test_files.hpp"

namespace farrier::diagnosis {
namespace electric_model_test {

/// The first joint of a shipped robot.
const robot::Joint& joint_of(const char* robot) {
  static const robot::Robot leg = robot::load_shipped("electric_leg");
  static const robot::Robot go1 = robot::load_shipped("go1");
  return std::string_view(robot) == "go1" ? go1.joints.front() : leg.joints.front();
}

ElectricModel model_of(const robot::Joint& joint) { return {*joint.electric, joint.swing_load, joint.push_limit}; }

/// A joint under random steps of its command, held near mid-travel, as its sensors would read it without noise.
Recording recorded(const robot::Joint& joint, double duration_s) {
  const plant::ElectricParams& a = *joint.electric;
  const double middle = 0.5 * a.travel;
  const double torque_share = a.rigid ? 0.15 : 1.0;  // the back-EMF takes most of it
  auto plant = plant::ElectricJoint::create(a, joint.swing_load, plant::equilibrium(a, joint.swing_load, middle, 0.0));
  const NoiseStream draw(7, "electric_model_test", "command");
  const double constant = a.gear_ratio * a.torque_constant_Nm_A;
  Recording recording;
  recording.period_s = 0.001;
  for (int k = 0; k < static_cast<int>(1000.0 * duration_s); ++k) {
    const plant::ElectricState& state = plant.value().state();
    const double torque = torque_share * joint.push_limit * (2.0 * draw.uniform(k / 50) - 1.0) -
                          joint.push_limit * (state.position - middle) / a.travel;
    recording.valve_current_A.push_back(torque / constant);
    recording.position.push_back(state.position);
    recording.velocity.push_back(state.velocity);
    recording.force.push_back(plant.value().load_cell_force());
    plant.value().step(recording.valve_current_A.back(), 0.0, recording.period_s);
  }
  return recording;
}

class ElectricModelOf : public testing::TestWithParam<const char*> {
 protected:
  const robot::Joint& joint() const { return joint_of(GetParam()); }
};

TEST_P(ElectricModelOf, FollowsTheWholeJointsTorqueAndMotion) {
  const ElectricModel model = model_of(joint());
  const JointData data = model.prepared(recorded(joint(), 3.0), joint().noise.position);
  const Span all{0, data.size()};
  const auto torque = model.simulate(data, all, Model::nominal(), Channel::kForce, {});
  const auto motion = model.simulate(data, all, Model::nominal(), Channel::kMotion, {});
  EXPECT_LT(relative_error(data.force, torque, 300), 0.005);
  EXPECT_LT(relative_error(data.motion, motion, 300), 0.0005);
}

TEST_P(ElectricModelOf, RespondsAsTheWholeJointDoes) {
  const ElectricModel model = model_of(joint());
  const plant::ElectricParams& a = *joint().electric;
  const Hold hold = model.hold();
  const NoiseStream draw(7, "electric_model_test", "steps");
  std::vector<double> current_A;
  for (int k = 0; k < 2000; ++k) {
    current_A.push_back(0.1 * joint().push_limit / model.torque_per_A() * (2.0 * draw.uniform(k / 20) - 1.0));
  }
  const std::vector<plant::JointReadings> readings = model.respond(Model::nominal(), current_A, 0.001);
  auto whole = plant::ElectricJoint::create(a, joint().swing_load,
                                            plant::equilibrium(a, joint().swing_load, 0.5 * a.travel, 0.0));
  std::vector<double> position, velocity, torque, read_position, read_velocity, read_torque;
  for (std::size_t k = 0; k < current_A.size(); ++k) {
    const plant::ElectricState& state = whole.value().state();
    position.push_back(state.position - 0.5 * a.travel);
    velocity.push_back(state.velocity);
    torque.push_back(whole.value().load_cell_force());
    read_position.push_back(readings[k].position - 0.5 * a.travel);
    read_velocity.push_back(readings[k].velocity);
    read_torque.push_back(readings[k].load_cell_force);
    const double held_Nm = hold.stiffness * position.back() + hold.damping * state.velocity;
    whole.value().step(current_A[k] - held_Nm / model.torque_per_A(), 0.0, 0.001);
  }
  EXPECT_LT(relative_error(position, read_position, 0), 0.005);
  EXPECT_LT(relative_error(velocity, read_velocity, 0), 0.005);
  EXPECT_LT(relative_error(torque, read_torque, 0), 0.005);
}

TEST_P(ElectricModelOf, HasDerivativesThatAreThoseOfDifferences) {
  const ElectricModel model = model_of(joint());
  const JointData data = model.prepared(recorded(joint(), 1.0), joint().noise.position);
  int checked = 0;
  for (plant::EffectId id = 0; id < plant::kNameableCount; ++id) {
    const ChannelMask shows = model.channels(id);
    const auto starts = model.starts(id, data);
    EXPECT_EQ(starts.empty(), !meet(shows, shows)) << plant::effect_info(id).name;
    for (std::size_t c = 0; !starts.empty() && c < kChannels; ++c) {
      if (shows[c]) {
        Model middle = Model::nominal();
        middle.effects = {{id, starts.front()}};
        // A wider step moves the ends of a play past the rotor.
        expect_slopes(model, data, middle, 0, static_cast<Channel>(c), 1e-6);
        ++checked;
      }
    }
  }
  EXPECT_GE(checked, 15);
}

TEST_P(ElectricModelOf, LacksTheEffectsOfOil) {
  const ElectricModel model = model_of(joint());
  for (const char* name : {"valve_bias", "internal_leakage", "piston_friction", "supply_droop"}) {
    const ChannelMask shows = model.channels(plant::find_nameable(name));
    EXPECT_FALSE(meet(shows, shows)) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Drives, ElectricModelOf, testing::Values("electric_leg", "go1"),
                         [](const auto& drive) { return std::string(drive.param); });

/// A recording of a joint that is held under a step of its command at sample 500.
Recording stalled(const robot::Joint& joint, double command_A) {
  Recording recording;
  recording.period_s = 0.001;
  const std::size_t samples = 1500;
  recording.position.assign(samples, 0.5 * joint.electric->travel);
  recording.velocity.assign(samples, 0.0);
  recording.force.assign(samples, 0.0);
  recording.valve_current_A.assign(samples, 0.0);
  std::fill(recording.valve_current_A.begin() + 500, recording.valve_current_A.end(), command_A);
  return recording;
}

/// Free running: the measured torque, which stays at 0, draws nothing.
constexpr Observer kFree{1e9, 1e9};

TEST(RigidDrive, ItsTorqueFollowsAStepAsAFirstOrderLagThatAnEffectMakesSlower) {
  const robot::Joint& joint = joint_of("go1");
  const plant::ElectricParams& a = *joint.electric;
  const ElectricModel model = model_of(joint);
  const double command_A = 0.2 * joint.actuator.valve_current_max_A;
  const JointData data = model.prepared(stalled(joint, command_A), joint.noise.position);
  Model slow = Model::nominal();
  slow.effects = {{plant::find_nameable("current_lag"), {0.004}}};
  const auto torque = model.simulate(data, {0, data.size()}, slow, Channel::kForce, kFree);
  const double last = a.gear_ratio * a.torque_constant_Nm_A * command_A;
  for (const std::size_t k : {500u, 501u, 504u, 520u}) {
    const double expected =
        last * (1.0 - std::exp(-1e-3 * static_cast<double>(k - 500) / (a.torque_time_constant_s + 0.004)));
    EXPECT_NEAR(torque[k], expected, 1e-9 * last) << k;
  }
}

TEST(SpringDrive, StalledItHasTheTorqueOfTheCurrentLimit) {
  const robot::Joint& joint = joint_of("electric_leg");
  const plant::ElectricParams& a = *joint.electric;
  const ElectricModel model = model_of(joint);
  const JointData data = model.prepared(stalled(joint, 20.0), joint.noise.position);
  Model limited = Model::nominal();
  const plant::EffectId limit = plant::find_nameable("current_limit");
  limited.effects = {{limit, {model.scales().fitted(plant::effect_info(limit).parameters[0], 12.0)}}};
  const auto torque = model.simulate(data, {0, data.size()}, limited, Channel::kForce, kFree);
  EXPECT_NEAR(torque.back(), 12.0 * a.gear_ratio * a.torque_constant_Nm_A, 1e-3);
}

TEST(StartsOfCogging, HaveThePeriodAndSizeOfARippleInTheTorque) {
  const robot::Joint& joint = joint_of("go1");
  const ElectricModel model = model_of(joint);
  Recording recording = recorded(joint, 4.0);
  constexpr double kPeriods = 36.0;
  constexpr double kAmplitude_Nm = 0.3;
  // The motor had to make what the ripple took away.
  for (std::size_t i = 0; i < recording.force.size(); ++i) {
    recording.force[i] -= kAmplitude_Nm * std::sin(kPeriods * recording.position[i] + 0.7);
  }
  const JointData data = model.prepared(recording, joint.noise.position);
  const auto starts = starts_of_cogging(data, *joint.electric, joint.swing_load, model.scales());
  ASSERT_FALSE(starts.empty());
  EXPECT_NEAR(starts[0][1], kPeriods, 2.0);
  EXPECT_NEAR(starts[0][0] * joint.push_limit, kAmplitude_Nm, 0.1);
}

TEST(StartsOfCogging, TrustNoCurrentsThatTheMotorMayNotHaveHad) {
  const robot::Joint& joint = joint_of("electric_leg");
  const ElectricModel model = model_of(joint);
  const double largest_A = joint.push_limit / model.torque_per_A();
  constexpr double kPeriods = 60.0;
  constexpr double kAmplitude = 0.03;
  const plant::EffectId limit = plant::find_nameable("current_limit");
  Model hidden = Model::nominal();
  hidden.effects = {{plant::find_nameable("cogging"), {kAmplitude, kPeriods, 0.7}},
                    {limit, {model.scales().fitted(plant::effect_info(limit).parameters[0], 0.6 * largest_A)}}};
  const NoiseStream draw(7, "electric_model_test", "limited");
  Recording recording;
  recording.period_s = 0.001;
  for (int k = 0; k < 4000; ++k) {
    recording.valve_current_A.push_back(largest_A * (2.0 * draw.uniform(k / 150) - 1.0));
  }
  const std::vector<plant::JointReadings> readings = model.respond(hidden, recording.valve_current_A, 0.001);
  const double middle = 0.5 * joint.electric->travel;
  const Hold hold = model.hold();
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const plant::JointReadings& now = readings[k];
    recording.position.push_back(now.position);
    recording.velocity.push_back(now.velocity);
    recording.force.push_back(now.load_cell_force);
    recording.valve_current_A[k] -=
        (hold.stiffness * (now.position - middle) + hold.damping * now.velocity) / model.torque_per_A();
  }
  const JointData data = model.prepared(recording, joint.noise.position);
  const auto starts = starts_of_cogging(data, *joint.electric, joint.swing_load, model.scales());
  ASSERT_FALSE(starts.empty());
  EXPECT_NEAR(starts[0][1], kPeriods, 3.0);
  EXPECT_GT(starts[0][0], 0.5 * kAmplitude);
}

}  // namespace electric_model_test
}  // namespace farrier::diagnosis
