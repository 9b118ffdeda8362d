// Loads that the joints of a robot on a ground move.

#include "robot/body_loads.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "body/dynamics/rigid_body.hpp"

namespace farrier::robot {
namespace body_loads_test {

Robot on_ground(const std::string& file) {
  return load_robot(std::string(FARRIER_ROBOTS) + "/" + file, {.on_ground = true}).value();
}

body::JointVector home_of(const Robot& robot) {
  body::JointVector home(static_cast<Eigen::Index>(robot.joints.size()));
  for (const Joint& joint : robot.joints) {
    home[joint.number] = joint.home_angle_rad;
  }
  return home;
}

// The acceleration under 1 Nm, from the equations of motion with the feet's forces as unknowns.
double acceleration_of(const Robot& robot, const std::vector<int>& standing, int joint) {
  auto body = body::RigidBody::create(*robot.body).value();
  body::BodyState state = body::BodyState::zero(body.joints());
  state.angles_rad = home_of(robot);
  body.set_state(state);
  const Eigen::Index n = body.velocities();
  const auto rows = 3 * static_cast<Eigen::Index>(standing.size());
  Eigen::MatrixXd equations = Eigen::MatrixXd::Zero(n + rows, n + rows);
  equations.topLeftCorner(n, n) = body.mass_matrix();
  for (std::size_t i = 0; i < standing.size(); ++i) {
    const Eigen::MatrixXd jacobian = body.foot_jacobian(standing[i]);
    equations.block(n + 3 * static_cast<Eigen::Index>(i), 0, 3, n) = jacobian;
    equations.block(0, n + 3 * static_cast<Eigen::Index>(i), n, 3) = -jacobian.transpose();
  }
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(n + rows);
  forces[body::kTrunkVelocities + joint] = 1.0;
  return equations.fullPivLu().solve(forces)[body::kTrunkVelocities + joint];
}

TEST(BodyLoads, AreTheInertiaThatTheEquationsOfMotionGive) {
  const Robot robot = on_ground("hyq.yaml");
  for (const std::vector<int>& standing : {std::vector<int>{}, {0, 3}, {0, 1, 2, 3}}) {
    const body::JointVector inertias = joint_inertias_kg_m2(*robot.body, home_of(robot), standing);
    for (int joint = 0; joint < 12; ++joint) {
      EXPECT_NEAR(inertias[joint] * acceleration_of(robot, standing, joint), 1.0, 1e-9) << joint;
    }
  }
}

// The knee of HyQ moves about 11 kg in swing and 660 kg in stance, the hip 123 kg and 3125 kg: computed by MuJoCo from
// the published masses, without the pistons.
TEST(BodyLoads, AreThoseOfHyq) {
  const Robot robot = on_ground("hyq.yaml");
  constexpr double kRelative = 0.05;
  const auto near = [](double is, double expected) { EXPECT_NEAR(is, expected, kRelative * expected); };
  near(robot.find("lf_kfe")->swing_load.mass, 11.0);
  near(robot.find("lf_kfe")->stance_load.mass, 660.0);
  near(robot.find("lf_hfe")->swing_load.mass, 123.0);
  near(robot.find("lf_hfe")->stance_load.mass, 3125.0);
  near(robot.find("lf_haa")->swing_load.mass, 0.247);
  near(robot.find("lf_haa")->stance_load.mass, 1.79);
}

TEST(BodyLoads, AreThoseOfTheFileOnABench) {
  const Robot robot = load_robot(std::string(FARRIER_ROBOTS) + "/hyq.yaml").value();
  EXPECT_EQ(robot.find("lf_kfe")->swing_load.mass, 2.5);
  EXPECT_EQ(robot.body->legs[0].links[2].armature_kg_m2, 0.0);
}

TEST(BodyLoads, HaveThePistonAsArmature) {
  const Robot robot = on_ground("hyq.yaml");
  const Joint& knee = *robot.find("lf_kfe");
  const double lever = knee.linkage.lever(knee.home_angle_rad);
  EXPECT_DOUBLE_EQ(robot.body->legs[0].links[2].armature_kg_m2, knee.actuator.piston_mass * lever * lever);
  EXPECT_EQ(on_ground("electric_quad.yaml").body->legs[0].links[2].armature_kg_m2, 0.0);
}

}  // namespace body_loads_test
}  // namespace farrier::robot
