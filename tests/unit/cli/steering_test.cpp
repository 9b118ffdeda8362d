#include "cli/drive/steering.hpp"

#include <gtest/gtest.h>

#include "cli/drive/terminal_keys.hpp"

namespace farrier::cli {
namespace steering_test {

constexpr locomotion::TrunkReferenceParams kLimits{};

TEST(Steering, WalksByStepsWithinTheLimits) {
  Steering steering(kLimits);
  EXPECT_EQ(steering.command().request, MotionRequest::kLie);
  steering.press(Key::kFaster);
  steering.press(Key::kTurnRight);
  EXPECT_EQ(steering.command().request, MotionRequest::kTrot);
  EXPECT_DOUBLE_EQ(steering.command().forward_m_s, 0.1);
  EXPECT_DOUBLE_EQ(steering.command().yaw_rate_rad_s, -0.1);
  for (int press = 0; press < 100; ++press) {
    steering.press(Key::kFaster);
    steering.press(Key::kLeft);
  }
  EXPECT_DOUBLE_EQ(steering.command().forward_m_s, kLimits.fastest_forward_m_s);
  EXPECT_DOUBLE_EQ(steering.command().left_m_s, kLimits.fastest_left_m_s);
}

TEST(Steering, ComesBackToZeroByAsManySteps) {
  Steering steering(kLimits);
  for (int press = 0; press < 7; ++press) {
    steering.press(Key::kFaster);
  }
  for (int press = 0; press < 7; ++press) {
    steering.press(Key::kSlower);
  }
  EXPECT_EQ(steering.command().forward_m_s, 0.0);
}

TEST(Steering, StandsOnTheStopKeyWithoutAVelocityThatComesBack) {
  Steering steering(kLimits);
  steering.press(Key::kFaster);
  steering.press(Key::kStop);
  EXPECT_EQ(steering.command().request, MotionRequest::kStand);
  steering.press(Key::kTurnLeft);
  EXPECT_EQ(steering.command().request, MotionRequest::kTrot);
  EXPECT_EQ(steering.command().forward_m_s, 0.0);
}

TEST(Steering, EndsOnceTheRobotLies) {
  Steering steering(kLimits);
  steering.press(Key::kFaster);
  steering.take(MotionMode::kTrot);
  steering.lose_terminal();
  EXPECT_EQ(steering.command().request, MotionRequest::kLie);
  EXPECT_FALSE(steering.ended());
  steering.press(Key::kFaster);
  EXPECT_EQ(steering.command().request, MotionRequest::kLie) << "no key counts any more";
  steering.take(MotionMode::kLie);
  EXPECT_TRUE(steering.ended());
}

TEST(Keys, AreReadFromBytesAndHalfAnArrowWaitsForItsRest) {
  std::string bytes = "w\x1b[A?x\x1b[";
  EXPECT_EQ(keys_in(bytes), (std::vector{Key::kFaster, Key::kFaster, Key::kNull}));
  EXPECT_EQ(bytes, "\x1b[");
  bytes += "D";
  EXPECT_EQ(keys_in(bytes), std::vector{Key::kTurnLeft});
  EXPECT_TRUE(bytes.empty());
}

}  // namespace steering_test
}  // namespace farrier::cli
