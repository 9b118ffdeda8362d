#include "body/engine/own_math.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace farrier::body::own_math {
namespace own_math_test {

// Two units in the last place of 1: both sides round.
constexpr double kRounding = 4.5e-16;
constexpr int kPoints = 20000;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(OwnMath, SineAndCosineAreThoseOfTheLibrary) {
  for (int i = -kPoints; i <= kPoints; ++i) {
    const double x = 8.0 * i / kPoints;
    double s = 0.0, c = 0.0;
    sine_cosine(x, &s, &c);
    ASSERT_NEAR(s, std::sin(x), kRounding) << x;
    ASSERT_NEAR(c, std::cos(x), kRounding) << x;
    ASSERT_EQ(s, sine(x));
    ASSERT_EQ(c, cosine(x));
  }
}

TEST(OwnMath, SineKeepsItsDigitsNearZero) {
  for (double x = 1e-300; x < 0.1; x *= 3.7) {
    ASSERT_NEAR(sine(x) / std::sin(x), 1.0, kRounding) << x;
  }
}

TEST(OwnMath, ArcTangentIsThatOfTheLibraryInAllQuadrants) {
  for (int i = -kPoints; i <= kPoints; ++i) {
    const double angle = std::numbers::pi * i / kPoints;
    const double y = 3.0 * std::sin(angle);
    const double x = 3.0 * std::cos(angle);
    ASSERT_NEAR(arc_tangent(y, x), std::atan2(y, x), 2.0 * kRounding) << angle;
  }
  for (const double y : {0.0, -0.0, 1.0, -1.0}) {
    for (const double x : {0.0, -0.0, 1.0, -1.0}) {
      EXPECT_NEAR(arc_tangent(y, x), std::atan2(y, x), kRounding) << y << " " << x;
    }
  }
}

TEST(OwnMath, PowerMultiplies) {
  EXPECT_EQ(power(0.3, 0.0), 1.0);
  EXPECT_EQ(power(0.3, 1.0), 0.3);
  EXPECT_EQ(power(0.3, 2.0), 0.3 * 0.3);
  EXPECT_EQ(power(-2.0, 3.0), -8.0);
}

TEST(OwnMath, AnswersNaNOutOfItsRange) {
  EXPECT_TRUE(std::isnan(sine(8.5)));
  EXPECT_TRUE(std::isnan(cosine(kNaN)));
  EXPECT_TRUE(std::isnan(arc_tangent(kNaN, 1.0)));
  EXPECT_TRUE(std::isnan(power(2.0, 0.5)));
  EXPECT_TRUE(std::isnan(power(2.0, kNaN)));
  EXPECT_TRUE(std::isnan(forbidden(1.0)));
}

}  // namespace own_math_test
}  // namespace farrier::body::own_math
