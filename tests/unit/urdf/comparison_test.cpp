#include "urdf/comparison.hpp"

#include <gtest/gtest.h>

#include "core/text.hpp"
#include "shipped.hpp"
#include "urdf/urdf_reader.hpp"
#include "urdf/urdf_text.hpp"

namespace farrier::urdf {
namespace comparison_test {

class OfHyq : public testing::Test {
 protected:
  const robot::Robot hyq_ = load_shipped("hyq");
  const std::string text_ = urdf_text(hyq_).value();

  Comparison found(const std::string& text) const {
    auto read = read_urdf_text(text, "hyq.urdf");
    EXPECT_TRUE(read.ok()) << config::to_string(read.error());
    return compare(read.value(), hyq_);
  }

  /// "where: message" of each difference, a line each.
  std::string differences(const std::string& text) const {
    std::string lines;
    for (const Difference& difference : found(text).differences) {
      lines += difference.where + ": " + difference.message + "\n";
    }
    return lines;
  }

  /// From the element of this name to the end.
  std::string at(const std::string& name, const std::string& from, const std::string& to) const {
    const std::size_t begin = text_.find("name=\"" + name + "\"");
    EXPECT_NE(begin, std::string::npos) << name;
    return text_.substr(0, begin) + with(text_.substr(begin), from, to);
  }
};

TEST_F(OfHyq, AMassIsNamedWithBothValues) {
  EXPECT_EQ(
      differences(at("lf_hip", "<mass value=\"2.93\"/>", "<mass value=\"3.93\"/>")),
      "lf_haa: mass 3.93 kg, in the robot file 2.93 kg\n: mass of the robot 85.756 kg, in the robot file 84.756 kg\n");
}

TEST_F(OfHyq, ATurnedAxisIsASignAndItsLimitsAreComparedInOurs) {
  std::string turned = at("lf_hfe", "<axis xyz=\"0 1 0\"/>", "<axis xyz=\"0 -1 0\"/>");
  const std::size_t joint = turned.find("name=\"lf_hfe\"");
  const robot::Joint& hfe = *hyq_.find("lf_hfe");
  turned = turned.substr(0, joint) +
           with(with(turned.substr(joint), "lower=\"" + config::number_text(hfe.angle_min_rad) + "\"",
                     "lower=\"" + config::number_text(-hfe.angle_max_rad) + "\""),
                "upper=\"" + config::number_text(hfe.angle_max_rad) + "\"",
                "upper=\"" + config::number_text(-hfe.angle_min_rad) + "\"");
  EXPECT_EQ(differences(turned),
            "lf_hfe: sign: axis [0, -1, 0], in the robot file [0, 1, 0]; angles, velocities and torques have the other "
            "sign\n");
}

TEST_F(OfHyq, AnInertiaAboutTheAxisIsRecognised) {
  body::RigidInertia link = hyq_.body->legs[0].links[1].inertia;
  link.tensor_kg_m2 +=
      link.mass_kg * (link.com_m.squaredNorm() * Eigen::Matrix3d::Identity() - link.com_m * link.com_m.transpose());
  robot::Robot doubled = hyq_;
  doubled.body->legs[0].links[1].inertia = link;
  const std::string text = differences(urdf_text(doubled).value());
  EXPECT_NE(text.find("lf_hfe: inertia about the centre of mass xx "), std::string::npos) << text;
  EXPECT_NE(text.find("which counts the mass twice"), std::string::npos) << text;
}

TEST_F(OfHyq, LimitsEffortsAndDampingAreCompared) {
  EXPECT_EQ(differences(at("rh_haa", "lower=\"-1.2\"", "lower=\"-1.22\"")),
            "rh_haa: limits -1.22 to 0.436332 rad, in the robot file -1.2 to 0.436332 rad\n");
  const std::string text = differences(at("rh_haa", "effort=\"1", "effort=\"2"));
  EXPECT_EQ(text.find("rh_haa: effort 2"), 0u) << text;
  EXPECT_NE(text.find(" Nm, the largest between the limits\n"), std::string::npos) << text;
  EXPECT_EQ(differences(at("rh_haa", "damping=\"0.1\"", "damping=\"0\"")),
            "rh_haa: damping 0 Nms/rad, in the robot file 0.1 Nms/rad (body.joint_damping_Nms_rad)\n");
}

// Frames of links may be turned as their author likes: the mechanism is the same.
TEST_F(OfHyq, TurnedFramesOfLinksDifferInNothing) {
  constexpr const char* kTurn = "rpy=\"0 0 1.5707963267948966\"";
  std::string turned = at("lf_hip", "rpy=\"0 0 0\"", "rpy=\"0 0 0\"");
  const body::Link& hip = hyq_.body->legs[0].links[0];
  const auto text = [](double x, double y, double z) {
    return config::number_text(x + 0.0) + " " + config::number_text(y + 0.0) + " " + config::number_text(z + 0.0);
  };
  const auto v = [&](const Eigen::Vector3d& u) { return text(u.x(), u.y(), u.z()); };
  const Eigen::Vector3d c = hip.inertia.com_m;
  // The hip's frame is turned by 90 degrees about z: x' = y, y' = -x.
  const std::size_t joint = turned.find("<joint name=\"lf_haa\"");
  turned = turned.substr(0, joint) + with(with(turned.substr(joint), "rpy=\"0 0 0\"", kTurn),
                                          "<axis xyz=\"" + v(hip.axis) + "\"",
                                          "<axis xyz=\"" + text(hip.axis.y(), -hip.axis.x(), hip.axis.z()) + "\"");
  const std::size_t link = turned.find("<link name=\"lf_hip\"");
  turned = turned.substr(0, link) +
           with(turned.substr(link), "<origin xyz=\"" + v(c) + "\" rpy=\"0 0 0\"",
                "<origin xyz=\"" + text(c.y(), -c.x(), c.z()) + "\" rpy=\"0 0 -1.5707963267948966\"");
  const std::size_t next = turned.find("<joint name=\"lf_hfe\"");
  turned = turned.substr(0, next) + with(turned.substr(next), "rpy=\"0 0 0\"", "rpy=\"0 0 -1.5707963267948966\"");
  EXPECT_EQ(differences(turned), "");
}

TEST_F(OfHyq, AMassOnAFixedJointCountsToTheLinkThatCarriesIt) {
  const std::string camera = with(text_, "</robot>",
                                  "<link name=\"camera\"><inertial><origin xyz=\"0 0 0\"/><mass value=\"1\"/>"
                                  "<inertia ixx=\"1e-3\" iyy=\"1e-3\" izz=\"1e-3\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>"
                                  "</inertial></link><joint name=\"camera\" type=\"fixed\"><origin xyz=\"0.5 0 0\"/>"
                                  "<parent link=\"trunk\"/><child link=\"camera\"/></joint></robot>");
  const std::string text = differences(camera);
  EXPECT_NE(text.find("trunk: mass 59.96 kg, in the robot file 58.96 kg\n"), std::string::npos) << text;
  EXPECT_NE(text.find("trunk: centre of mass [0.0181721, "), std::string::npos) << text;
}

// Other names: joints are found by their place.
TEST_F(OfHyq, JointsWithOtherNamesAreFoundByTheirPlace) {
  std::string renamed = text_;
  int leg = 0;
  for (const char* name : {"lf", "rf", "lh", "rh"}) {
    for (const char* joint : {"haa", "hfe", "kfe"}) {
      renamed = with(renamed, "<joint name=\"" + std::string(name) + "_" + joint + "\"",
                     "<joint name=\"leg" + std::to_string(leg) + "_" + joint + "\"");
    }
    ++leg;
  }
  const Comparison found = this->found(renamed);
  EXPECT_EQ(found.compared_joints, 12);
  EXPECT_EQ(found.differences.size(), 12u);
  for (const Difference& difference : found.differences) {
    EXPECT_EQ(difference.message.find("name leg"), 0u) << difference.where << ": " << difference.message;
  }
}

TEST_F(OfHyq, NamesThatDifferInCaseAndEndingAreTheSameJoint) {
  EXPECT_EQ(differences(with(text_, "<joint name=\"lf_haa\"", "<joint name=\"LF_HAA_joint\"")),
            "lf_haa: name LF_HAA_joint, in the robot file lf_haa\n");
}

TEST_F(OfHyq, WhatOneFormatCannotSayIsListed) {
  const Comparison found =
      this->found(with(text_, "</robot>", "<transmission name=\"t\"/><transmission name=\"u\"/><gazebo/></robot>"));
  EXPECT_TRUE(found.differences.empty());
  EXPECT_EQ(found.only_in_urdf, (std::vector<std::string>{"1 gazebo", "2 transmissions"}));
  const std::string robot = join(found.only_in_robot, "\n");
  EXPECT_NE(robot.find("torque that changes with the angle, "), std::string::npos) << robot;
  EXPECT_NE(robot.find("valves, cylinders and vane motors"), std::string::npos) << robot;
}

TEST_F(OfHyq, AnotherJointOfTheUrdfIsNamed) {
  const std::string arm =
      with(text_, "</robot>",
           "<link name=\"arm\"/><joint name=\"arm_1\" type=\"revolute\"><parent link=\"trunk\"/>"
           "<child link=\"arm\"/><limit lower=\"0\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint>"
           "</robot>");
  EXPECT_NE(differences(arm).find(": joint arm_1 of the URDF (line "), std::string::npos) << differences(arm);
}

}  // namespace comparison_test
}  // namespace farrier::urdf
