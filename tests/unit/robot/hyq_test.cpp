#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "robot/leg_inertia.hpp"
#include "test_files.hpp"

namespace farrier::robot {
namespace hyq_test {

class Hyq : public testing::Test {
 protected:
  const Robot hyq_ = load_shipped("hyq");

  const Joint& joint(const char* name) const {
    const Joint* found = hyq_.find(name);
    EXPECT_NE(found, nullptr) << name;
    return *found;
  }
  static bool is_cylinder(const Joint& joint) { return joint.actuator.area_a != joint.actuator.area_b; }
};

TEST_F(Hyq, NumbersItsJointsLegByLeg) {
  ASSERT_EQ(hyq_.joints.size(), 12u);
  std::size_t number = 0;
  for (const char* leg : {"lf", "rf", "lh", "rh"}) {
    for (const char* kind : {"_haa", "_hfe", "_kfe"}) {
      const Joint& joint = hyq_.joints[number];
      EXPECT_EQ(joint.name, std::string(leg) + kind);
      EXPECT_EQ(joint.number, number);
      EXPECT_EQ(joint.leg, static_cast<int>(number / 3));
      EXPECT_EQ(joint.index_in_leg, static_cast<int>(number % 3));
      EXPECT_EQ(hyq_.plan.legs[number / 3].joints[number % 3].joint, number);
      ++number;
    }
  }
  EXPECT_EQ(hyq_.find("lf"), nullptr);
}

TEST_F(Hyq, HasTheAreasOfTheThesisAndForcesByDirection) {
  for (const Joint& joint : hyq_.joints) {
    if (is_cylinder(joint)) {
      EXPECT_NEAR(joint.actuator.area_a, 2.0106e-4, 0.5e-8);  // Table A.1, to its digits
      EXPECT_NEAR(joint.actuator.area_b, 1.2252e-4, 0.5e-8);
      EXPECT_NEAR(joint.push_limit, 3217.0, 0.5);  // 160 bar times the areas
      EXPECT_NEAR(joint.pull_limit, 1960.0, 0.5);
    } else {
      EXPECT_NEAR(joint.push_limit, 160e5 * 6.87e-6, 1e-9);
      EXPECT_EQ(joint.push_limit, joint.pull_limit);
    }
  }
}

TEST_F(Hyq, HasTheOilStiffnessThatIsPublished) {
  // beta_e (A_a^2 / V_a + A_b^2 / V_b) at mid-stroke
  const plant::ActuatorParams& a = joint("lf_kfe").actuator;
  const double half = 0.5 * a.stroke;
  const double stiffness_N_m = a.bulk_modulus_Pa * (a.area_a * a.area_a / (a.line_volume_m3 + a.area_a * half) +
                                                    a.area_b * a.area_b / (a.line_volume_m3 + a.area_b * half));
  EXPECT_NEAR(stiffness_N_m, 6.6e6, 0.05e6);
  EXPECT_GT(a.stop_stiffness, 2.0 * stiffness_N_m);                           // the stop, not the oil, ends a stroke
  EXPECT_LT(joint("lf_kfe").push_limit, 0.01 * a.stroke * a.stop_stiffness);  // and gives way by less than 1 %
}

TEST_F(Hyq, KeepsEveryJointWithinStrokeAndLeverRange) {
  constexpr int kPoints = 200;
  for (const Joint& joint : hyq_.joints) {
    EXPECT_GT(joint.home_angle_rad, joint.angle_min_rad) << joint.name;
    EXPECT_LT(joint.home_angle_rad, joint.angle_max_rad) << joint.name;
    double least = joint.actuator.stroke;
    double most = 0.0;
    for (int i = 0; i <= kPoints; ++i) {
      const double q = joint.angle_min_rad + (joint.angle_max_rad - joint.angle_min_rad) * i / kPoints;
      const double position = joint.linkage.position(q);
      least = std::min(least, position);
      most = std::max(most, position);
      if (is_cylinder(joint)) {
        EXPECT_GT(std::abs(joint.linkage.lever(q)), 0.022) << joint.name << " at " << q;
        EXPECT_LT(std::abs(joint.linkage.lever(q)), 0.0451) << joint.name << " at " << q;
      }
    }
    constexpr double kRounding = 1e-12;
    EXPECT_GE(least, -kRounding) << joint.name;
    EXPECT_LE(most, joint.actuator.stroke) << joint.name;
    if (is_cylinder(joint)) {
      EXPECT_NEAR(most - least, 0.078, 0.0005) << joint.name;  // 78 of the 80 mm
    }
  }
}

TEST_F(Hyq, MirrorsTheFlexionJointsOfTheFrontLegs) {
  EXPECT_EQ(joint("lf_hfe").home_angle_rad, 0.75);
  EXPECT_EQ(joint("lh_hfe").home_angle_rad, -0.75);
  EXPECT_EQ(joint("rf_kfe").home_angle_rad, -1.5);
  EXPECT_EQ(joint("rh_kfe").home_angle_rad, 1.5);
  EXPECT_EQ(joint("lf_haa").home_angle_rad, joint("rh_haa").home_angle_rad);
  for (const char* kind : {"_hfe", "_kfe"}) {
    const Joint& front = joint((std::string("lf") + kind).c_str());
    const Joint& hind = joint((std::string("lh") + kind).c_str());
    EXPECT_EQ(front.angle_min_rad, -hind.angle_max_rad);
    EXPECT_EQ(front.angle_max_rad, -hind.angle_min_rad);
    for (const double q : {hind.angle_min_rad, hind.home_angle_rad, hind.angle_max_rad}) {
      EXPECT_EQ(front.linkage.position(-q), hind.linkage.position(q));
      EXPECT_EQ(front.linkage.lever(-q), -hind.linkage.lever(q));
    }
  }
}

TEST_F(Hyq, WeighsAndStandsAsPublished) {
  EXPECT_NEAR(hyq_.plan.body_weight_N, 84.756 * 9.81, 1e-6);
  EXPECT_NEAR(hyq_.plan.gait.hip_height_m, 0.574, 0.0005);
  EXPECT_TRUE(gait::validate(hyq_.plan).ok());
  EXPECT_EQ(hyq_.plan.legs[0].phase_offset, hyq_.plan.legs[3].phase_offset);
  EXPECT_EQ(hyq_.plan.legs[1].phase_offset, hyq_.plan.legs[2].phase_offset);
}

TEST_F(Hyq, GivesTheHipItsLegAsLoad) {
  const Joint& haa = joint("lf_haa");
  EXPECT_NEAR(haa.swing_load.mass, 0.307, 0.001);  // worked by hand from the table, three digits
  for (const char* other : {"rf_haa", "lh_haa", "rh_haa"}) {
    constexpr double kRounding = 1e-14;  // front and hind legs differ by signs that cancel
    EXPECT_NEAR(joint(other).swing_load.mass, haa.swing_load.mass, kRounding);
  }
  EXPECT_EQ(haa.stance_load.mass, haa.swing_load.mass);
}

TEST_F(Hyq, SeesTheCylinderThroughALeverInItsMotors) {
  const Joint& haa = joint("rh_haa");
  const Joint& hfe = joint("rh_hfe");
  const Joint& kfe = joint("rh_kfe");
  const double lever_m =
      0.5 * (std::abs(hfe.linkage.lever(hfe.home_angle_rad)) + std::abs(kfe.linkage.lever(kfe.home_angle_rad)));
  constexpr double kRounding = 1e-14;
  EXPECT_NEAR(haa.actuator.piston_damping, 700.0 * lever_m * lever_m, 1e3 * kRounding);
  EXPECT_NEAR(haa.swing_load.damping, 500.0 * lever_m * lever_m, 1e3 * kRounding);
  EXPECT_NEAR(haa.noise.position, 2e-6 / lever_m, kRounding);
  EXPECT_NEAR(haa.noise.velocity, 1.5e-3 / lever_m, kRounding);
  EXPECT_NEAR(haa.noise.force, 1.0 * lever_m, kRounding);
  EXPECT_EQ(haa.normalisation.position, 0.5 * haa.actuator.stroke);
  // Equal power at full scale.
  EXPECT_NEAR(haa.normalisation.velocity * haa.normalisation.force, 1.2 * 5000.0, 1e4 * kRounding);
  EXPECT_EQ(hfe.normalisation.position, 0.04);
  EXPECT_EQ(hfe.normalisation.current_A, 0.01);
}

TEST(LegInertia, IsSteinersForPointMasses) {
  Body body;
  body.hip_offset_m = 0.1;
  body.upper_leg_m = 0.4;
  body.upper_leg = {2.0, 0.2, 0.0, 0.0, {}, {}};
  body.lower_leg = {1.0, 0.3, 0.0, 0.0, {}, {}};
  const double hfe = 0.6;
  const double kfe = -1.1;
  const double knee = 0.1 + 0.2 * std::cos(hfe);
  const double shin = 0.1 + 0.4 * std::cos(hfe) + 0.3 * std::cos(hfe + kfe);
  EXPECT_NEAR(leg_inertia_about_haa_kg_m2(body, hfe, kfe), 2.0 * knee * knee + shin * shin, 1e-14);
}

TEST(LegInertia, TurnsTensorsWithTheLeg) {
  Body body;
  body.upper_leg = {0.0, 0.0, 0.0, 0.0, {3.0, 5.0, 7.0, 0.5}, {}};
  constexpr double kRounding = 1e-14;
  EXPECT_NEAR(leg_inertia_about_haa_kg_m2(body, 0.0, 0.0), 5.0, kRounding);                         // along y
  EXPECT_NEAR(leg_inertia_about_haa_kg_m2(body, std::numbers::pi / 2, 0.0), 3.0, kRounding);        // along x
  EXPECT_NEAR(leg_inertia_about_haa_kg_m2(body, std::numbers::pi / 4, 0.0), 4.0 + 0.5, kRounding);  // between
}

}  // namespace hyq_test
}  // namespace farrier::robot
