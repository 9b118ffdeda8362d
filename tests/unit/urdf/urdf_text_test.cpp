#include "urdf/urdf_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "shipped.hpp"
#include "tests/support/scratch_directory.hpp"
#include "urdf/comparison.hpp"
#include "urdf/joint_limits.hpp"
#include "urdf/urdf_reader.hpp"

namespace farrier::urdf {
namespace urdf_text_test {

class Shipped : public testing::TestWithParam<const char*> {};

TEST_P(Shipped, UrdfDiffersInNothingFromItsRobotFile) {
  const robot::Robot robot = load_shipped(GetParam());
  const auto read = read_urdf_text(urdf_text(robot).value(), "robot.urdf");
  ASSERT_TRUE(read.ok()) << config::to_string(read.error());
  const Tolerances exact{.relative = 1e-12, .length_m = 1e-12, .angle_rad = 1e-12};
  const Comparison found = compare(read.value(), robot, exact);
  for (const Difference& difference : found.differences) {
    ADD_FAILURE() << difference.where << ": " << difference.message;
  }
  EXPECT_EQ(found.compared_joints, static_cast<int>(robot.joints.size()));
}

TEST_P(Shipped, UrdfPassesCheckUrdf) {
  if (std::system("command -v check_urdf > /dev/null") != 0) {
    GTEST_SKIP() << "check_urdf is of Debian's package liburdfdom-tools";
  }
  const test::ScratchDirectory scratch;
  std::ofstream(scratch.file("robot.urdf")) << urdf_text(load_shipped(GetParam())).value();
  const std::string command = "check_urdf " + scratch.file("robot.urdf") + " > " + scratch.file("answer") +
                              " 2>&1 && ! grep -iE 'error|warn' " + scratch.file("answer");
  EXPECT_EQ(std::system(command.c_str()), 0);
}

INSTANTIATE_TEST_SUITE_P(Robots, Shipped, testing::ValuesIn(kWithBody));

TEST(UrdfText, JointsHaveTheNamesOfTheRobotFileAndTheRootHasNoInertia) {
  const auto model = read_urdf_text(urdf_text(load_shipped("hyq")).value(), "hyq.urdf").value();
  EXPECT_EQ(model.name, "hyq");
  const UrdfLink& root = model.links[static_cast<std::size_t>(model.root)];
  EXPECT_EQ(root.name, "base_link");
  EXPECT_FALSE(root.inertia.has_value());
  int moving = 0;
  for (const UrdfJoint& joint : model.joints) {
    moving += joint.moves() ? 1 : 0;
  }
  EXPECT_EQ(moving, 12);
}

TEST(UrdfText, RefusesARobotWithoutRigidBodies) {
  const auto text = urdf_text(load_shipped("fc1d"));
  ASSERT_FALSE(text.ok());
  EXPECT_NE(text.error().message.find("needs body.trunk"), std::string::npos) << text.error().message;
}

// A motor has the same torque everywhere; a cylinder's follows its lever, which is 0.045 m at most.
TEST(JointLimits, TorquesFollowTheLinkage) {
  const robot::Robot robot = load_shipped("hyq");
  const robot::Joint& haa = *robot.find("lf_haa");
  const JointLimits motor = limits_of(haa, robot.file);
  EXPECT_DOUBLE_EQ(motor.effort_Nm, std::max(haa.push_limit, haa.pull_limit));
  EXPECT_DOUBLE_EQ(motor.least_effort_Nm, motor.effort_Nm);
  const robot::Joint& kfe = *robot.find("lf_kfe");
  const JointLimits cylinder = limits_of(kfe, robot.file);
  EXPECT_NEAR(cylinder.effort_Nm, 0.045 * std::max(kfe.push_limit, kfe.pull_limit), 0.5);
  EXPECT_LT(cylinder.least_effort_Nm, 0.6 * cylinder.effort_Nm);
}

// With p_t = 0 the piston's forces balance at p_a = alpha p_b, and both orifices pass K u sqrt(drop).
TEST(JointLimits, ACylinderRunsAtTheSpeedAtWhichBothOrificesBalance) {
  const robot::Robot robot = load_shipped("hyq");
  const robot::Joint& joint = *robot.find("lf_hfe");
  const plant::ActuatorParams& a = joint.actuator;
  const double alpha = a.area_b / a.area_a;
  double least_lever_m = 1.0;
  for (double q = joint.angle_min_rad; q <= joint.angle_max_rad; q += 1e-4) {
    least_lever_m = std::min(least_lever_m, std::abs(joint.linkage.lever(q)));
  }
  const double speed_m_s = limits_of(joint, robot.file).velocity_rad_s * least_lever_m;
  const double k = a.valve_gain * a.valve_current_max_A;
  const double p_a_Pa = a.supply_pressure_Pa - std::pow(speed_m_s * a.area_a / k, 2);
  const double p_b_Pa = std::pow(speed_m_s * a.area_b / k, 2);
  EXPECT_NEAR(p_a_Pa / (alpha * p_b_Pa), 1.0, 1e-3);
}

TEST(JointLimits, AJointKnownByItsLimitsHasThem) {
  const robot::Robot robot = load_shipped("go1");
  const JointLimits limits = limits_of(*robot.find("lf_haa"), robot.file);
  EXPECT_DOUBLE_EQ(limits.effort_Nm, 23.7);
  EXPECT_DOUBLE_EQ(limits.velocity_rad_s, 30.1);
}

}  // namespace urdf_text_test
}  // namespace farrier::urdf
