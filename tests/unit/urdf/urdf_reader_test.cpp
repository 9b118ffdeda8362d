#include "urdf/urdf_reader.hpp"

#include <gtest/gtest.h>

#include "shipped.hpp"
#include "urdf/urdf_text.hpp"

namespace farrier::urdf {
namespace urdf_reader_test {

std::string problems_of(const std::string& text) {
  const auto read = read_urdf_text(text, "a.urdf");
  return read ? "" : config::to_string(read.error());
}

constexpr const char* kLeg =
    "<robot name='a'>\n<link name='base'/>\n<link name='leg'>\n"
    "<inertial><origin xyz='0 0 -0.1'/><mass value='2'/>\n"
    "<inertia ixx='0.1' ixy='0' ixz='0' iyy='0.1' iyz='0' izz='0.1'/></inertial></link>\n"
    "<joint name='hip' type='revolute'><parent link='base'/><child link='leg'/>\n<axis xyz='0 2 0'/>\n"
    "<limit lower='-1' upper='1' effort='10' velocity='5'/></joint>\n</robot>\n";

TEST(UrdfReader, ReadsLinksJointsAndLimits) {
  const UrdfModel model = read_urdf_text(kLeg, "a.urdf").value();
  ASSERT_EQ(model.joints.size(), 1u);
  EXPECT_EQ(model.joints[0].axis, Eigen::Vector3d::UnitY()) << "of unit length";
  EXPECT_EQ(model.joints[0].effort_Nm, 10.0);
  EXPECT_EQ(model.links[1].inertia->mass_kg, 2.0);
  EXPECT_EQ(model.root, 0);
}

TEST(UrdfReader, TurnsATensorByTheRotationOfItsOrigin) {
  const std::string turned =
      with(with(kLeg, "<origin xyz='0 0 -0.1'/>", "<origin xyz='0 0 0' rpy='0 0 1.5707963267948966'/>"), "ixx='0.1'",
           "ixx='0.05'");
  const Eigen::Matrix3d tensor = read_urdf_text(turned, "a.urdf").value().links[1].inertia->tensor_kg_m2;
  EXPECT_NEAR(tensor(0, 0), 0.1, 1e-12);
  EXPECT_NEAR(tensor(1, 1), 0.05, 1e-12);
}

TEST(UrdfReader, NamesEachMistakeWithItsLine) {
  EXPECT_EQ(problems_of(with(kLeg, "child link='leg'", "child link='lag'")),
            "a.urdf:6: hip: has a child that is no link: 'lag'\n");
  EXPECT_EQ(problems_of(with(kLeg, "effort='10'", "effort='ten'")), "a.urdf:8: limit: effort: 'ten' is no number\n");
  EXPECT_EQ(problems_of(with(kLeg, "xyz='0 2 0'", "xyz='0 0 0'")), "a.urdf:7: hip: has an axis of length zero\n");
  EXPECT_EQ(problems_of(with(kLeg, "xyz='0 2 0'", "xyz='0 1'")), "a.urdf:7: axis: xyz: give 3 numbers\n");
  EXPECT_EQ(
      problems_of(with(kLeg, "ixx='0.1'", "ixx='0.3'")),
      "a.urdf:4: leg: has a tensor about its centre of mass that no masses can have: no principal moment may exceed "
      "the sum of the others\n");
  EXPECT_EQ(
      problems_of(with(kLeg, "type='revolute'", "type='hinge'")),
      "a.urdf:6: hip: has no type that URDF knows: give revolute, continuous, prismatic, fixed, floating or planar\n");
  EXPECT_EQ(problems_of(with(kLeg, "<link name='base'/>", "<link name='base'/><link name='lost'/>")),
            "a.urdf:1: has 2 root links: one link alone must be the child of no joint\n");
  EXPECT_EQ(problems_of(with(kLeg, "<link name='base'/>", "<link name='leg'/>")).substr(0, 50),
            std::string("a.urdf:3: leg: is a second link of that name\n").substr(0, 50) + "a.urd");
}

TEST(UrdfReader, RefusesALoop) {
  const std::string loop = with(kLeg, "</robot>",
                                "<link name='c'/><link name='d'/>\n"
                                "<joint name='x' type='fixed'><parent link='c'/><child link='d'/></joint>\n"
                                "<joint name='y' type='fixed'><parent link='d'/><child link='c'/></joint></robot>");
  EXPECT_NE(problems_of(loop).find("c: is part of a loop"), std::string::npos) << problems_of(loop);
}

TEST(UrdfReader, RefusesOtherFormats) {
  EXPECT_EQ(problems_of("name: hyq\n").substr(0, 29), "a.urdf:1: is no XML that can ");
  EXPECT_EQ(problems_of("<sdf version='1.7'/>"), "a.urdf:1: begins with <sdf>, a URDF with <robot>\n");
  EXPECT_EQ(problems_of("<robot name='a'><link name='b'/><xacro:leg/></robot>"),
            "a.urdf:1: is xacro: expand it first, xacro robot.urdf.xacro > robot.urdf\n");
}

TEST(UrdfReader, EndsOnEveryBeginningOfAUrdf) {
  const std::string text = kLeg;
  for (std::size_t length = 0; length < text.size() - 1; ++length) {
    EXPECT_FALSE(read_urdf_text(text.substr(0, length), "a.urdf").ok() && length < text.find("</robot>")) << length;
  }
}

}  // namespace urdf_reader_test
}  // namespace farrier::urdf
