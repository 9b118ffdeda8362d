#include "robot/locomotion_model.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "core/noise.hpp"
#include "gait/leg_kinematics.hpp"
#include "robot/locomotion_params.hpp"
#include "test_files.hpp"

namespace farrier::robot {
namespace locomotion_test {

using Eigen::Vector3d;
using locomotion::LegReadings;
using locomotion::TrunkMotion;

constexpr double kRounding = 1e-12;
const TrunkMotion kUpright{.gravity_m_s2 = {0.0, 0.0, -9.81}};

class HyqLocomotion : public testing::Test {
 protected:
  Vector3d draw() { return {draw_one(), draw_one(), draw_one()}; }

  locomotion::PerLeg<LegReadings> draw_legs() {
    locomotion::PerLeg<LegReadings> legs;
    for (LegReadings& leg : legs) {
      leg.position_rad = draw();
      leg.velocity_rad_s = 3.0 * draw();
    }
    return legs;
  }

  locomotion::BodyState state_of(const locomotion::PerLeg<LegReadings>& legs, const TrunkMotion& trunk) const {
    locomotion::BodyState state;
    model_.update({legs.data(), 4}, trunk, state);
    return state;
  }

  const gait::LegGeometry& geometry(std::size_t leg) const { return hyq_.plan.legs[leg].geometry; }

  const Robot hyq_ = load_shipped("hyq");
  const LocomotionModel model_ = LocomotionModel::create(*hyq_.body).value();

 private:
  double draw_one() { return 3.0 * draws_.uniform(tick_++) - 1.5; }

  const NoiseStream draws_{1, "hyq", "readings"};
  Tick tick_ = 0;
};

TEST_F(HyqLocomotion, HasTheKinematicsOfTheGait) {
  for (int pose = 0; pose < 50; ++pose) {
    const auto legs = draw_legs();
    const locomotion::BodyState state = state_of(legs, {.gravity_m_s2 = draw(), .angular_velocity_rad_s = draw()});
    for (std::size_t leg = 0; leg < 4; ++leg) {
      const Vector3d& q = legs[leg].position_rad;
      const Vector3d& rate = legs[leg].velocity_rad_s;
      const Vector3d hip = hyq_.locomotion->mounts[leg].hip_m;
      EXPECT_LT((state.legs[leg].foot_m - hip - gait::fk(geometry(leg), q)).norm(), kRounding);
      EXPECT_LT((state.legs[leg].jacobian - gait::jacobian(geometry(leg), q)).norm(), kRounding);
      EXPECT_LT((state.legs[leg].foot_velocity_m_s - gait::jacobian(geometry(leg), q) * rate).norm(), 10 * kRounding);
      EXPECT_LT((state.legs[leg].foot_bias_m_s2 - gait::jacobian_rate(geometry(leg), q, rate) * rate).norm(), 1e-10);
    }
  }
}

TEST_F(HyqLocomotion, TurnsTheShankByItsJoints) {
  const auto legs = draw_legs();
  const locomotion::BodyState state = state_of(legs, {kUpright.gravity_m_s2, draw()});
  // HFE and KFE of the left front leg turn about one axis, which HAA turns about -x.
  const double haa = legs[0].position_rad.x();
  const Vector3d lateral(0.0, std::cos(haa), -std::sin(haa));
  const Vector3d& rate = legs[0].velocity_rad_s;
  EXPECT_LT((state.legs[0].shank_rate_rad_s - (rate.y() + rate.z()) * lateral + rate.x() * Vector3d::UnitX()).norm(),
            1e-11);
}

TEST_F(HyqLocomotion, FeelsGravityInTheTrunksAxes) {
  const auto legs = [] {
    locomotion::PerLeg<LegReadings> at_rest;
    at_rest.fill({.position_rad = {-0.2, 0.75, -1.5}});
    return at_rest;
  }();
  for (const Vector3d& down :
       {Vector3d(0, 0, -9.81), Vector3d(9.81, 0, 0), Vector3d(-9.81, 0, 0), Vector3d(1, 2, -9)}) {
    const TrunkMotion trunk{.gravity_m_s2 = 9.81 * down.normalized()};
    const Vector3d torque = state_of(legs, trunk).legs[0].bias_torque_Nm;
    // Potential energy: a joint's torque against gravity is the change of m g . com per radian.
    for (int joint = 0; joint < 3; ++joint) {
      constexpr double kStep_rad = 1e-5;
      auto up = legs;
      auto back = legs;
      up[0].position_rad[joint] += kStep_rad;
      back[0].position_rad[joint] -= kStep_rad;
      const Vector3d moved = state_of(up, trunk).com_m - state_of(back, trunk).com_m;
      EXPECT_NEAR(torque[joint], -model_.mass_kg() * trunk.gravity_m_s2.dot(moved) / (2.0 * kStep_rad), 1e-5);
    }
  }
}

TEST_F(HyqLocomotion, FeelsTheFrictionOfItsJoints) {
  body::BodyModel rough = *hyq_.body;
  constexpr std::array kDamping_Nms_rad{0.5, 1.0, 2.0};
  for (std::size_t leg = 0; leg < rough.legs.size(); ++leg) {
    for (std::size_t joint = 0; joint < kDamping_Nms_rad.size(); ++joint) {
      rough.legs[leg].links[joint].known_damping_Nms_rad = static_cast<double>(leg + 1) * kDamping_Nms_rad[joint];
    }
  }
  const LocomotionModel model = LocomotionModel::create(rough).value();
  const auto legs = draw_legs();
  const locomotion::BodyState smooth = state_of(legs, kUpright);
  locomotion::BodyState state;
  model.update({legs.data(), 4}, kUpright, state);
  for (std::size_t leg = 0; leg < 4; ++leg) {
    const Vector3d friction_Nm = state.legs[leg].bias_torque_Nm - smooth.legs[leg].bias_torque_Nm;
    const Vector3d damping_Nms_rad(kDamping_Nms_rad[0], kDamping_Nms_rad[1], kDamping_Nms_rad[2]);
    const Vector3d expected_Nm = static_cast<double>(leg + 1) * damping_Nms_rad.cwiseProduct(legs[leg].velocity_rad_s);
    EXPECT_LT((friction_Nm - expected_Nm).norm(), kRounding);
  }
}

TEST_F(HyqLocomotion, KnowsTheWholeMass) {
  EXPECT_NEAR(model_.mass_kg(), 84.756, kRounding);
  EXPECT_EQ(model_.leg_count(), 4);
}

TEST_F(HyqLocomotion, TakesPlacesFromBodyAndLegs) {
  const locomotion::LocomotionParams& params = *hyq_.locomotion;
  EXPECT_EQ(params.estimator.foot_radius_m, 0.02175);
  EXPECT_EQ(params.mounts[1].hip_m, Vector3d(0.3735, -0.207, 0.0));
  EXPECT_EQ(params.mounts[1].outward, -1.0);
  EXPECT_EQ(params.mounts[1].folded_rad, Vector3d(-0.28, 1.05, -2.1)) << "a front leg";
  EXPECT_EQ(params.mounts[3].folded_rad, Vector3d(-0.28, -1.05, 2.1)) << "a hind leg";
}

TEST_F(HyqLocomotion, DrawsNoTouchdowns) {
  EXPECT_GT(hyq_.plan.gait.touchdown_jitter_s, 0.0);
  EXPECT_EQ(locomotion_plan(hyq_.plan).gait.touchdown_jitter_s, 0.0);
}

TEST(LocomotionSection, HasUnitsInTheTableOfParameters) {
  const std::string table = parameter_table();
  EXPECT_NE(table.find("| `locomotion.trunk.horizontal_gain_1_s2` | 1_s2 |"), std::string::npos);
  EXPECT_NE(table.find("| `locomotion.estimator.foot_slip_m_s_rtHz` | m_s_rtHz |"), std::string::npos);
}

std::string problems_of(const std::string& text) {
  const auto robot = load_robot_text(text, "hyq.yaml");
  return robot ? "" : to_string(robot.error());
}

TEST(LocomotionSection, IsRefusedWithoutATrunk) {
  std::string text = text_of("hyq");
  const std::size_t trunk = text.find("  trunk:\n    com_x_m");
  text.erase(trunk, text.find("  foot_radius_m") - trunk);
  EXPECT_NE(problems_of(text).find("locomotion: is for a robot with body.trunk: give that too, or leave it out"),
            std::string::npos)
      << problems_of(text);
}

TEST(LocomotionSection, IsRefusedWithAPoseBeyondAJointsLimits) {
  const std::string text = replaced(text_of("hyq"), "folded_kfe_rad: 2.1", "folded_kfe_rad: 2.5");
  EXPECT_EQ(problems_of(text), "hyq.yaml:" + std::to_string(line_of(text, "folded_kfe_rad: 2.5")) +
                                   ": locomotion.folded_kfe_rad: is 2.5, but joint kfe goes from 0.3490659 to "
                                   "2.443461: give an angle between\n");
}

TEST(LocomotionSection, IsRefusedWithFeetThatReachNothing) {
  const std::string high = replaced(text_of("hyq"), "largest_height_m: 0.66", "largest_height_m: 0.75");
  EXPECT_EQ(problems_of(high).substr(0, problems_of(high).find('\n')),
            "hyq.yaml:" + std::to_string(line_of(high, "largest_height_m: 0.75")) +
                ": locomotion.reference: has largest_height_m 0.75, at which the foot of leg lf does not reach the "
                "ground: give less, or a larger longest_leg_m");
  const std::string one = replaced(text_of("hyq"), "[-0.3735, -0.207, 0]", "[-0.3735, -0.207, 0.3]");
  EXPECT_NE(problems_of(one).find("the foot of leg rh does not reach the ground"), std::string::npos);
  EXPECT_EQ(problems_of(one).find("leg lf"), std::string::npos);
}

TEST(LocomotionSection, IsRefusedWithALegLongerThanItsLinks) {
  const std::string text = replaced(text_of("hyq"), "longest_leg_m: 0.73", "longest_leg_m: 0.78");
  EXPECT_EQ(problems_of(text),
            "hyq.yaml:" + std::to_string(line_of(text, "  leg:\n    pose_stiffness")) +
                ": locomotion.leg: has longest_leg_m 0.78, but a straight leg has 0.771: give less\n");
}

TEST(LocomotionFile, RefusesATouchdownThatCouldOnlyBeFeltAfterItsPlan) {
  const auto with = [](const char* felt) {
    return replaced(text_of("hyq"), "  mode: {folded",
                    std::string("  felt_touchdown: {") + felt + "}\n  mode: {folded");
  };
  const std::string late = with("least_swing_s: 0.24");
  EXPECT_EQ(problems_of(late), "hyq.yaml:" + std::to_string(line_of(late, "felt_touchdown:")) +
                                   ": locomotion.felt_touchdown: has least_swing_s 0.24 and debounce_s 0.003, but the "
                                   "gains of swing act for 0.24 s: give less, or on: false\n");
  EXPECT_EQ(problems_of(with("on: false, least_swing_s: 0.24")), "");
  EXPECT_NE(problems_of(with("force_N: 0")).find("force_N"), std::string::npos);
  EXPECT_NE(problems_of(with("debounce_s: 1")).find("debounce_s"), std::string::npos);
}

}  // namespace locomotion_test
}  // namespace farrier::robot
