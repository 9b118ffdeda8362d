#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "plant/linkage.hpp"

namespace farrier::plant {
namespace linkage_test {

constexpr double kDegree = std::numbers::pi / 180.0;

struct LegJoint {
  const char* name;
  TriangleParams triangle;
  double q_min;
  double q_max;
};

/// HyQ: a 0.3219 (0.3218), b 0.045 m, retracted 0.281 m; front legs count HFE and KFE the other way.
std::vector<LegJoint> hyq_joints() {
  const TriangleParams hfe{0.3219, 0.045, 0.5 * std::numbers::pi + 0.1089, +1.0, +1.0, 0.281};
  const TriangleParams kfe{0.3218, 0.045, std::numbers::pi - 0.1403 - 0.1047, -1.0, +1.0, 0.281};
  TriangleParams front_hfe = hfe;
  TriangleParams front_kfe = kfe;
  front_hfe.mirror = front_kfe.mirror = -1.0;
  return {{"hind hfe", hfe, -70 * kDegree, 50 * kDegree},
          {"hind kfe", kfe, 20 * kDegree, 140 * kDegree},
          {"front hfe", front_hfe, -50 * kDegree, 70 * kDegree},
          {"front kfe", front_kfe, -140 * kDegree, -20 * kDegree}};
}

template <class Check>
void at_angles(const LegJoint& joint, Check check) {
  for (int i = 0; i <= 50; ++i) {
    check(joint.q_min + (joint.q_max - joint.q_min) * i / 50.0);
  }
}

TEST(Linkage, JointLimitsUseSeventyEightOfTheEightyMillimetres) {
  for (const LegJoint& joint : hyq_joints()) {
    const Linkage linkage = Linkage::triangle(joint.triangle).value();
    const auto [low, high] = std::minmax({linkage.position(joint.q_min), linkage.position(joint.q_max)});
    EXPECT_GE(low, 0.0) << joint.name;
    EXPECT_LE(high, 0.080) << joint.name;
    EXPECT_NEAR(high - low, 0.078, 0.0005) << joint.name;
  }
}

TEST(Linkage, LeverIsTheDerivativeOfPosition) {
  for (const LegJoint& joint : hyq_joints()) {
    const Linkage linkage = Linkage::triangle(joint.triangle).value();
    at_angles(joint, [&](double q) {
      // Central differences of 1e-5 rad: h^2 / 6 x''' ~ 1e-12 m, rounding 1e-16 / 1e-5 = 1e-11 m.
      const double slope = (linkage.position(q + 1e-5) - linkage.position(q - 1e-5)) / 2e-5;
      EXPECT_NEAR(linkage.lever(q), slope, 1e-10) << joint.name;
      const double bend = (linkage.lever(q + 1e-5) - linkage.lever(q - 1e-5)) / 2e-5;
      EXPECT_NEAR(linkage.lever_slope(q), bend, 1e-9) << joint.name;
    });
  }
}

TEST(Linkage, LeverIsTheTrianglesHeightOnTheCylinder) {
  for (const LegJoint& joint : hyq_joints()) {
    const Linkage linkage = Linkage::triangle(joint.triangle).value();
    const double a = joint.triangle.side_a_m;
    const double b = joint.triangle.side_b_m;
    at_angles(joint, [&](double q) {
      const double c = linkage.position(q) + joint.triangle.retracted_length_m;
      const double height = a * std::sin(std::acos((a * a + c * c - b * b) / (2.0 * a * c)));
      EXPECT_NEAR(std::abs(linkage.lever(q)), height, 1e-12) << joint.name;
    });
  }
}

TEST(Linkage, AngleUndoesPosition) {
  for (const LegJoint& joint : hyq_joints()) {
    const Linkage linkage = Linkage::triangle(joint.triangle).value();
    at_angles(joint, [&](double q) { EXPECT_NEAR(linkage.angle(linkage.position(q)), q, 1e-13) << joint.name; });
  }
}

TEST(Linkage, CarriesTheSamePowerOnBothSides) {
  for (const LegJoint& joint : hyq_joints()) {
    const Linkage linkage = Linkage::triangle(joint.triangle).value();
    at_angles(joint, [&](double q) {
      const double power_W = 900.0 * 0.3;
      EXPECT_NEAR(linkage.torque(q, 900.0) * linkage.angular_velocity(q, 0.3), power_W, 1e-12 * power_W);
      EXPECT_NEAR(linkage.force(q, linkage.torque(q, 900.0)), 900.0, 1e-12 * 900.0);
    });
  }
}

TEST(Linkage, FrontLegsMirrorHindLegs) {
  const auto joints = hyq_joints();
  const Linkage hind = Linkage::triangle(joints[1].triangle).value();
  const Linkage front = Linkage::triangle(joints[3].triangle).value();
  EXPECT_EQ(front.position(-1.2), hind.position(1.2));
  EXPECT_EQ(front.lever(-1.2), -hind.lever(1.2));
  EXPECT_EQ(front.lever_slope(-1.2), hind.lever_slope(1.2));
}

TEST(Linkage, GivesTheNearerEndOutOfReach) {
  const Linkage linkage = Linkage::triangle(hyq_joints()[0].triangle).value();
  EXPECT_TRUE(std::isfinite(linkage.angle(-1.0)));
  EXPECT_GT(linkage.angle(1.0), linkage.angle(0.0));
  EXPECT_EQ(linkage.angular_velocity(linkage.angle(1.0), 0.3), 0.0);
}

TEST(Linkage, RotaryMotorCountsFromItsZero) {
  const Linkage motor = Linkage::direct(1.0, -1.2);
  EXPECT_EQ(motor.position(-1.2), 0.0);
  EXPECT_DOUBLE_EQ(motor.angle(motor.position(0.3)), 0.3);
  EXPECT_EQ(motor.torque(0.3, 50.0), 50.0);
  EXPECT_EQ(motor.lever_slope(0.3), 0.0);
}

TEST(Linkage, RejectsImpossibleTriangles) {
  const auto refused = Linkage::triangle({0.3, 0.0, 4.0, 0.5, 1.0, 0.281});
  ASSERT_FALSE(refused.ok());
  for (const char* word : {"side_b_m", "angle_at_zero_rad", "angle_sign"}) {
    EXPECT_NE(refused.error().message.find(word), std::string::npos) << refused.error().message;
  }
}

}  // namespace linkage_test
}  // namespace farrier::plant
