#include "gait/leg_kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/unit/gait/plan.hpp"

namespace farrier::gait {
namespace leg_kinematics_test {

constexpr double kRounding = 1e-12;  // of lengths below 1 m and angles below 3 rad, some operations each

struct Pose {
  LegGeometry geometry;
  Eigen::Vector3d angles;
};

// All four legs: home, nearly straight, folded, abducted both ways, and a generic pose.
std::vector<Pose> poses() {
  std::vector<Pose> all;
  for (const LegPlan& leg : hyq_plan().legs) {
    const double m = leg.geometry.front ? 1.0 : -1.0;
    for (const Eigen::Vector3d& q : std::vector<Eigen::Vector3d>{{-0.2, 0.75 * m, -1.5 * m},
                                                                 {0.0, 0.06 * m, -0.12 * m},
                                                                 {0.0, 1.2 * m, -2.4 * m},
                                                                 {-1.2, 0.2 * m, -0.9 * m},
                                                                 {0.43, -0.8 * m, -1.1 * m},
                                                                 {-0.31, 0.47 * m, -1.83 * m}}) {
      all.push_back({leg.geometry, q});
    }
  }
  return all;
}

TEST(LegKinematics, InverseFindsTheAnglesTheForwardStartedFrom) {
  for (const auto& [geometry, q] : poses()) {
    const auto found = ik(geometry, fk(geometry, q));
    ASSERT_TRUE(found.has_value()) << q.transpose();
    EXPECT_LT((*found - q).norm(), 1e2 * kRounding) << q.transpose();  // a straight knee magnifies rounding by 1/q_2
  }
}

TEST(LegKinematics, ForwardReachesThePointTheInverseWasAskedFor) {
  for (const LegPlan& leg : hyq_plan().legs) {
    for (const Eigen::Vector3d& foot : {Eigen::Vector3d{0.0, 0.0, -0.6}, {0.2, 0.1, -0.5}, {-0.15, -0.2, -0.45}}) {
      const auto angles = ik(leg.geometry, foot);
      ASSERT_TRUE(angles.has_value());
      EXPECT_LT((fk(leg.geometry, *angles) - foot).norm(), kRounding);
    }
  }
}

// IIT's home pose puts the HAA axis 0.574 m above the centre of the foot sphere, so 0.574 + 0.02175 m above the ground.
TEST(LegKinematics, HomePosePutsTheFootAtThePublishedHeightBelowTheHipAndOutward) {
  for (const LegPlan& leg : hyq_plan().legs) {
    const Eigen::Vector3d foot = fk(leg.geometry, {-0.2, leg.joints[1].home_angle_rad, leg.joints[2].home_angle_rad});
    constexpr double kPublishedDigits_m = 0.0005;
    EXPECT_NEAR(foot.z(), -0.574, kPublishedDigits_m) << leg.name;
    EXPECT_LT(std::abs(foot.x()), 0.01) << leg.name;
    EXPECT_EQ(foot.y() > 0.0, leg.geometry.left) << leg.name;
  }
}

TEST(LegKinematics, KneesPointTowardTheMiddleOfTheRobot) {
  for (const LegPlan& leg : hyq_plan().legs) {
    const auto angles = ik(leg.geometry, {0.0, 0.0, -0.55});
    ASSERT_TRUE(angles.has_value());
    const double knee_x = -leg.geometry.upper_m * std::sin((*angles)[1]);
    EXPECT_EQ(knee_x < 0.0, leg.geometry.front) << leg.name;
  }
}

TEST(LegKinematics, InverseRefusesPointsOutOfReachOrAboveTheHip) {
  const LegGeometry geometry;
  EXPECT_FALSE(ik(geometry, {0.0, 0.0, -0.8}));
  EXPECT_FALSE(ik(geometry, {0.0, 0.0, -0.08}));  // closer than the folded leg
  EXPECT_FALSE(ik(geometry, {0.1, 0.1, 0.4}));
  EXPECT_FALSE(ik(geometry, {std::nan(""), 0.0, -0.5}));
}

TEST(LegKinematics, JacobianIsTheDerivativeOfTheForwardKinematics) {
  constexpr double kStep = 1e-5;
  constexpr double kTolerance = 1e-10;  // truncation h^2/6 x 0.8 m, rounding 1e-16/h
  for (const auto& [geometry, q] : poses()) {
    Eigen::Matrix3d numeric;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
      numeric.col(i) = (fk(geometry, q + step) - fk(geometry, q - step)) / (2.0 * kStep);
    }
    const Eigen::Matrix3d exact = jacobian(geometry, q);
    EXPECT_LT((exact - numeric).norm(), kTolerance) << "exact\n" << exact << "\nby perturbation\n" << numeric;
  }
}

TEST(LegKinematics, JacobianRateIsTheDerivativeOfTheJacobianAlongTheMotion) {
  constexpr double kStep_s = 1e-5;
  constexpr double kTolerance = 1e-8;  // velocities of 3 rad/s: truncation h^2/6 x 27 x 0.8 m, rounding 1e-16/h
  const Eigen::Vector3d rates{0.7, -2.1, 3.0};
  for (const auto& [geometry, q] : poses()) {
    const Eigen::Matrix3d numeric =
        (jacobian(geometry, q + kStep_s * rates) - jacobian(geometry, q - kStep_s * rates)) / (2.0 * kStep_s);
    const Eigen::Matrix3d exact = jacobian_rate(geometry, q, rates);
    EXPECT_LT((exact - numeric).norm(), kTolerance) << "exact\n" << exact << "\nby perturbation\n" << numeric;
  }
}

TEST(LegKinematics, GroundTorquesDoTheWorkOfTheGroundForceOnTheFoot) {
  constexpr double kForce_N = 416.0;
  const Eigen::Vector3d rates{0.7, -2.1, 3.0};
  for (const auto& [geometry, q] : poses()) {
    const double joint_power = ground_torques(geometry, q, kForce_N).dot(rates);
    const double foot_power = kForce_N * (jacobian(geometry, q) * rates).z();
    EXPECT_NEAR(joint_power, foot_power, kForce_N * kRounding);
  }
}

// The ground folds the leg: it turns a front knee (q < 0) further negative, a hind knee further positive.
TEST(LegKinematics, GroundForceFoldsTheKnee) {
  for (const LegPlan& leg : hyq_plan().legs) {
    const double home = leg.joints[2].home_angle_rad;
    const Eigen::Vector3d torques = ground_torques(leg.geometry, {-0.2, leg.joints[1].home_angle_rad, home}, 416.0);
    EXPECT_GT(torques[2] * home, 0.0) << leg.name;
  }
}

}  // namespace leg_kinematics_test
}  // namespace farrier::gait
