#include <gtest/gtest.h>

#include "plant/linear_model.hpp"
#include "test_files.hpp"

namespace farrier::robot {
namespace rig_test {

TEST(Fc1d, IsTheRigOfTheThesis) {
  const Robot rig = load_shipped("fc1d");
  ASSERT_EQ(rig.joints.size(), 1u);
  const Joint& joint = rig.joints[0];
  EXPECT_EQ(joint.name, "fc1d");
  EXPECT_EQ(joint.form, control::Form::kFullState);
  EXPECT_EQ(joint.actuator.bulk_modulus_Pa, 5.5e8);
  EXPECT_EQ(joint.actuator.valve_gain, 1.6704e-6);
  EXPECT_EQ(joint.actuator.supply_pressure_Pa, 125e5);
  EXPECT_EQ(joint.actuator.line_volume_m3, 6.8047e-6);
  EXPECT_EQ(joint.actuator.piston_damping, 700.0);
  EXPECT_EQ(joint.swing_load.mass, 2.5);
  EXPECT_EQ(joint.stance_load.mass, 50.0);
  EXPECT_EQ(joint.stance_load.stiffness, 21480.0);
  EXPECT_EQ(joint.swing_load.equilibrium_position, 0.04);
  EXPECT_EQ(joint.linkage.position(0.03), 0.03);
  EXPECT_EQ(joint.linkage.lever(0.03), 1.0);
  EXPECT_EQ(joint.stiffness_Nm_rad, 0.0);
  EXPECT_EQ(rig.plan.body_weight_N, 0.0);
  EXPECT_EQ(rig.plan.gait.reference, gait::ReferenceKind::kMultisine);
  EXPECT_EQ(rig.plan.gait.multisine_frequencies_Hz, (std::vector<double>{2, 5, 10}));
  EXPECT_EQ(rig.plan.gait.multisine_amplitude_N, 160.0);
}

// Golden: an independent computation of the thesis's LQR from Table A.2 with V_pl set right, at (50 kg, 500 Ns/m); its
// Figs 7.4 and 7.8 show about [0, -4, 8]. Opening valve, mid-stroke.
TEST(Fc1d, LeadsToTheGainsTheThesisShows) {
  const Robot rig = load_shipped("fc1d");
  const Joint& joint = rig.joints.at(0);
  const plant::LinearModel model =
      plant::linearise_load_cell_force(joint.actuator, joint.stance_load, {.position = 0.04, .valve_sign = 1.0},
                                       plant::Volumes::kMoving, plant::PistonMass::kNeglected);
  const auto gains = control::design_lqr(model.a, model.b, rig.period_s, joint.design.weights, joint.normalisation,
                                         joint.form, rig.loop_delay_lockstep);
  ASSERT_TRUE(gains.ok()) << control::to_string(gains.error());
  EXPECT_NEAR(gains.value().position, 0.065, 0.5e-3);  // half of the last digit given
  EXPECT_NEAR(gains.value().velocity, -4.47, 0.5e-2);
  EXPECT_NEAR(gains.value().force, 8.55, 0.5e-2);
}

TEST(Robot, LeadsToAControllerForEveryJointLoadAndClock) {
  for (const char* name : {"hyq", "fc1d", "fc1d_real"}) {
    const Robot robot = load_shipped(name);
    for (const Joint& joint : robot.joints) {
      for (const plant::LoadParams& load : {joint.swing_load, joint.stance_load}) {
        for (const int delay : {robot.loop_delay_lockstep, robot.loop_delay_realtime}) {
          const plant::LinearModel model = plant::linearise_load_cell_force(
              joint.actuator, load, {.position = joint.linkage.position(joint.home_angle_rad)});
          const auto gains = control::design_lqr(model.a, model.b, robot.period_s, joint.design.weights,
                                                 joint.normalisation, joint.form, delay);
          EXPECT_TRUE(gains.ok()) << joint.name << ", " << load.mass << " kg, delay " << delay;
        }
      }
    }
  }
}

// The rig's integral factor is its own: docs/decisions/0014.
TEST(Robot, TakesItsWeightsFromTheThesis) {
  for (const char* name : {"hyq", "fc1d", "fc1d_real"}) {
    for (const Joint& joint : load_shipped(name).joints) {
      EXPECT_EQ(joint.design.weights.integral, 2.5);
      EXPECT_EQ(joint.design.weights.position, 1.0);
      EXPECT_EQ(joint.design.weights.velocity, 1.0);
      EXPECT_EQ(joint.design.weights.force, 5000.0);
      EXPECT_EQ(joint.design.weights.input, 0.1);
      EXPECT_EQ(joint.design.weights.integral_factor, joint.name == "fc1d" ? 14.0 : 6.0);
    }
  }
}

}  // namespace rig_test
}  // namespace farrier::robot
