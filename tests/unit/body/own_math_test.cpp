#include "body/engine/own_math.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/portable_math.hpp"

namespace farrier::body::own_math {
namespace own_math_test {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(OwnMath, GivesSineAndCosineInTheFormOfTheLibrary) {
  double s = 0.0, c = 0.0;
  sine_cosine(1.3, &s, &c);
  EXPECT_EQ(s, portable::sin(1.3));
  EXPECT_EQ(c, portable::cos(1.3));
}

TEST(OwnMath, PowerMultiplies) {
  EXPECT_EQ(power(0.3, 0.0), 1.0);
  EXPECT_EQ(power(0.3, 1.0), 0.3);
  EXPECT_EQ(power(0.3, 2.0), 0.3 * 0.3);
  EXPECT_EQ(power(-2.0, 3.0), -8.0);
}

TEST(OwnMath, AnswersNaNOutOfItsRange) {
  EXPECT_TRUE(std::isnan(power(2.0, 0.5)));
  EXPECT_TRUE(std::isnan(power(2.0, kNaN)));
  EXPECT_TRUE(std::isnan(forbidden(1.0)));
}

}  // namespace own_math_test
}  // namespace farrier::body::own_math
