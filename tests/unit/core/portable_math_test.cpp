#include "core/portable_math.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace farrier::portable {
namespace portable_math_test {

// The bounds of the header's comments. The reference is the C library in long double, which rounds to 1e-19.
constexpr int kPoints = 20000;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Long = long double;

double absolute(double got, Long exact) { return static_cast<double>(std::abs(got - exact)); }
double relative(double got, Long exact) { return static_cast<double>(std::abs((got - exact) / exact)); }

TEST(PortableMath, SineAndCosineKeepTheirBoundUpToTheLargestAngle) {
  for (const double range : {0.8, 8.0, 1e3, kLargestAngle}) {
    for (int i = -kPoints; i <= kPoints; ++i) {
      const double x = range * i / kPoints;
      const SineCosine at = sincos(x);
      ASSERT_LE(absolute(at.sine, std::sin(Long{x})), 3e-16) << x;
      ASSERT_LE(absolute(at.cosine, std::cos(Long{x})), 3e-16) << x;
      ASSERT_EQ(at.sine, sin(x));
      ASSERT_EQ(at.cosine, cos(x));
    }
  }
}

TEST(PortableMath, SineKeepsItsDigitsNearZero) {
  for (double x = 1e-300; x < 0.1; x *= 3.7) {
    ASSERT_LE(relative(sin(x), std::sin(Long{x})), 3e-16) << x;
  }
}

TEST(PortableMath, TurnsAreReducedExactly) {
  for (int i = -kPoints; i <= kPoints; ++i) {
    for (const double range : {1.0, 3600.0}) {
      const double x = range * i / kPoints;
      const Long angle = 2.0L * std::numbers::pi_v<Long> * (Long{x} - std::round(Long{x}));
      ASSERT_LE(absolute(sin_of_turns(x), std::sin(angle)), 4e-16) << x;
      ASSERT_LE(absolute(cos_of_turns(x), std::cos(angle)), 4e-16) << x;
    }
  }
  EXPECT_EQ(sin_of_turns(0x1p50), 0.0);
  EXPECT_EQ(cos_of_turns(0.25), 0.0);
}

TEST(PortableMath, ArcTangentKeepsItsBoundInAllQuadrants) {
  for (int i = -kPoints; i <= kPoints; ++i) {
    const double angle = std::numbers::pi * i / kPoints;
    const double y = 3.0 * std::sin(angle);
    const double x = 3.0 * std::cos(angle);
    ASSERT_LE(absolute(atan2(y, x), std::atan2(Long{y}, Long{x})), 6e-16) << angle;
  }
  for (double y = 1e-300; y < 0.5; y *= 3.7) {
    ASSERT_LE(relative(atan2(y, 1.0), std::atan2(Long{y}, 1.0L)), 6e-16) << y;
  }
  for (const double y : {0.0, -0.0, 1.0, -1.0}) {
    for (const double x : {0.0, -0.0, 1.0, -1.0}) {
      EXPECT_LE(absolute(atan2(y, x), std::atan2(Long{y}, Long{x})), 6e-16) << y << " " << x;
    }
  }
}

TEST(PortableMath, ArcCosineKeepsItsBoundUpToBothEnds) {
  for (int i = -kPoints; i <= kPoints; ++i) {
    const double x = static_cast<double>(i) / kPoints;
    ASSERT_LE(absolute(acos(x), std::acos(Long{x})), 1e-15) << x;
  }
  for (double below = 1e-15; below < 0.1; below *= 3.7) {
    ASSERT_LE(absolute(acos(1.0 - below), std::acos(Long{1.0 - below})), 1e-15) << below;
  }
  EXPECT_EQ(acos(1.5), 0.0);
  EXPECT_EQ(acos(-1.5), std::numbers::pi);
}

TEST(PortableMath, LogarithmKeepsItsDigitsNearOneAndAtBothEnds) {
  for (int i = 1; i <= kPoints; ++i) {
    const double x = 2.0 * i / kPoints;
    ASSERT_LE(absolute(log(x), std::log(Long{x})), 4e-16 * std::abs(std::log(x))) << x;
  }
  for (double x = 5e-324; x < 1e308; x *= 1.7) {
    ASSERT_LE(relative(log(x), std::log(Long{x})), 4e-16) << x;
  }
  EXPECT_EQ(log(1.0), 0.0);
}

TEST(PortableMath, ExponentialAndPowerKeepTheirBounds) {
  for (int i = -kPoints; i <= kPoints; ++i) {
    const double x = 700.0 * i / kPoints;
    ASSERT_LE(relative(exp(x), std::exp(Long{x})), 2e-15) << x;
    const double exponent = 5.0 * i / kPoints;
    for (const double base : {1e-3, 0.9, 1.0, 3141.6}) {
      ASSERT_LE(relative(pow(base, exponent), std::pow(Long{base}, Long{exponent})),
                2e-15 * (1.0 + std::abs(exponent * std::log(base))))
          << base << " " << exponent;
    }
  }
  EXPECT_EQ(pow(0.0, 0.5), 0.0);
}

TEST(PortableMath, ExponentialDecayIsOneBelowZeroAndZeroFarAbove) {
  for (double x = 0.0; x < 700.0; x += 0.0371) {
    ASSERT_LE(relative(exponential_decay(x), std::exp(Long{-x})), 1e-15) << x;
  }
  EXPECT_EQ(exponential_decay(0.0), 1.0);
  EXPECT_EQ(exponential_decay(-1.0), 1.0);
  EXPECT_EQ(exponential_decay(1e9), 0.0);
}

TEST(PortableMath, HyperbolicFunctionsKeepTheirBounds) {
  for (double x = -30.0; x < 30.0; x += 0.0137) {
    ASSERT_LE(absolute(tanh(x), std::tanh(Long{x})), 4e-16) << x;
    ASSERT_LE(relative(cosh(x), std::cosh(Long{x})), 4e-15) << x;
    ASSERT_LE(relative(sinh(x), std::sinh(Long{x})), 6e-15) << x;
  }
  for (double x = 1e-300; x < 1.0; x *= 3.7) {
    ASSERT_LE(relative(sinh(x), std::sinh(Long{x})), 6e-15) << x;
  }
  EXPECT_EQ(tanh(0.0), 0.0);
  EXPECT_EQ(sinh(0.0), 0.0);
}

TEST(PortableMath, NearestExponentRoundsTheLogarithm) {
  for (double x = 1e-300; x < 1e300; x *= 1.037) {
    ASSERT_EQ(nearest_exponent(x), std::lround(std::log2(x))) << x;
  }
  EXPECT_EQ(nearest_exponent(1.0), 0);
  EXPECT_EQ(nearest_exponent(0x1p-20), -20);
}

TEST(PortableMath, AnswersNaNOutOfItsRange) {
  for (const double x : {1.1e6, -1.1e6, kInfinity, kNaN}) {
    EXPECT_TRUE(std::isnan(sin(x))) << x;
    EXPECT_TRUE(std::isnan(cos(x))) << x;
  }
  for (const double x : {0x1p51, kInfinity, kNaN}) {
    EXPECT_TRUE(std::isnan(sin_of_turns(x))) << x;
    EXPECT_TRUE(std::isnan(cos_of_turns(x))) << x;
    EXPECT_TRUE(std::isnan(atan2(1.0, x)) || x == 0x1p51) << x;
  }
  EXPECT_TRUE(std::isnan(acos(kNaN)));
  EXPECT_TRUE(std::isnan(log(kNaN)));
  EXPECT_TRUE(std::isnan(log(-1.0)));
  EXPECT_TRUE(std::isnan(exp(kNaN)));
  EXPECT_EQ(log(0.0), -kInfinity);
  EXPECT_EQ(log(kInfinity), kInfinity);
  EXPECT_EQ(exp(701.0), kInfinity);
  EXPECT_EQ(exp(-701.0), 0.0);
}

}  // namespace portable_math_test
}  // namespace farrier::portable
