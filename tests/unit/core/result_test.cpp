#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "core/result.hpp"

namespace farrier {
namespace result_test {

enum class Refusal { kTooSmall, kTooLarge };

Result<int, Refusal> checked(int value) {
  if (value < 0) {
    return Refusal::kTooSmall;
  }
  if (value > 9) {
    return Refusal::kTooLarge;
  }
  return value;
}

TEST(Result, HoldsTheValueOfASuccess) {
  const auto result = checked(3);
  ASSERT_TRUE(result);
  EXPECT_EQ(result.value(), 3);
}

TEST(Result, HoldsTheReasonOfARefusal) {
  const auto result = checked(10);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error(), Refusal::kTooLarge);
}

TEST(Result, MovesOutAValueThatCannotBeCopied) {
  Result<std::unique_ptr<int>> result(std::make_unique<int>(5));
  const std::unique_ptr<int> taken = std::move(result).value();
  EXPECT_EQ(*taken, 5);
}

TEST(Result, LetsTheValueBeChangedInPlace) {
  Result<std::string> result(std::string("valve"));
  result.value() += " shut";
  EXPECT_EQ(result.value(), "valve shut");
}

TEST(Result, CountsTheValueOfARefusalAsABug) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_DEATH(static_cast<void>(checked(-1).value()), "value\\(\\) of a refused Result");
}

TEST(Result, PrintsTheErrorBehindAValueThatWasRefused) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const Result<int> result = Error{"robots/x.yaml is not there"};
  EXPECT_DEATH(static_cast<void>(result.value()), "value\\(\\) of a refused Result: robots/x.yaml is not there");
}

TEST(Result, GoesOnWithTheValueOrKeepsTheRefusal) {
  const auto half = [](int value) -> Result<double, Refusal> { return 0.5 * value; };
  EXPECT_EQ(checked(3).and_then(half).value(), 1.5);
  EXPECT_EQ(checked(10).and_then(half).error(), Refusal::kTooLarge);
  EXPECT_EQ(checked(3).and_then([](int value) { return checked(value - 4); }).error(), Refusal::kTooSmall);
}

TEST(Result, CountsTheErrorOfASuccessAsABug) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_DEATH(static_cast<void>(checked(1).error()), "error\\(\\) of a successful Result");
}

TEST(Ensure, NamesTheConditionAndThePlace) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const int joints = 0;
  EXPECT_DEATH(FARRIER_ENSURE(joints > 0, "a robot has joints"),
               "bug: a robot has joints \\(joints > 0\\) at .*result_test");
}

}  // namespace result_test
}  // namespace farrier
