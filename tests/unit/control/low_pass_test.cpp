#include "control/law/low_pass.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace farrier::control {
namespace low_pass_test {

constexpr double kRate_Hz = 1000.0;

std::complex<double> response(const FilterCoefficients& c, double frequency_Hz) {
  const std::complex<double> back = std::polar(1.0, -2.0 * std::numbers::pi * frequency_Hz / kRate_Hz);
  return (c.b[0] + back * (c.b[1] + back * c.b[2])) / (1.0 + back * (c.a[0] + back * c.a[1]));
}

TEST(LowPass, WithoutCutOffLetsEverythingThroughBitForBit) {
  LowPass filter(design_low_pass({}, kRate_Hz).value());
  filter.settle(3.0);
  for (const double value : {0.1, -7.3, 1e300, 5e-324}) {
    EXPECT_EQ(filter.take(value), value);
  }
}

// At the cut-off the discrete filter is the continuous one: 1 / (1 + i), and 1 / (2 D i).
TEST(LowPass, HasTheContinuousResponseAtItsCutOff) {
  for (const double cut_off_Hz : {1.0, 50.0, 100.0, 200.0, 400.0}) {
    const auto first = response(design_low_pass({cut_off_Hz, 1, 1.0}, kRate_Hz).value(), cut_off_Hz);
    EXPECT_NEAR(std::abs(first - 1.0 / std::complex<double>(1.0, 1.0)), 0.0, 1e-11) << cut_off_Hz;
    for (const double damping : {0.5, 0.7071, 1.0}) {
      const auto second = response(design_low_pass({cut_off_Hz, 2, damping}, kRate_Hz).value(), cut_off_Hz);
      EXPECT_NEAR(std::abs(second - 1.0 / std::complex<double>(0.0, 2.0 * damping)), 0.0, 1e-11) << cut_off_Hz;
    }
  }
}

TEST(LowPass, FollowsTheContinuousFilterFarBelowHalfTheRate) {
  const auto c = design_low_pass({100.0, 2, 0.7071}, kRate_Hz).value();
  for (double f = 1.0; f < 100.0; f += 7.0) {
    const std::complex<double> s(0.0, f / 100.0);
    const auto expected = 1.0 / (s * s + 2.0 * 0.7071 * s + 1.0);
    // tan bends the frequency axis by at most (pi 0.1)^2 / 3 = 3.3 % below the cut-off.
    EXPECT_NEAR(std::abs(response(c, f) - expected), 0.0, 0.033) << f;
  }
}

TEST(LowPass, RunsAsItsTransferFunctionSays) {
  const auto c = design_low_pass({80.0, 2, 0.5}, kRate_Hz).value();
  LowPass filter(c);
  constexpr double kFrequency_Hz = 30.0;
  const auto gain = response(c, kFrequency_Hz);
  for (int k = 0; k < 1000; ++k) {
    const double angle = 2.0 * std::numbers::pi * kFrequency_Hz * k / kRate_Hz;
    const double out = filter.take(std::cos(angle));
    if (k > 500) {  // its transient fades with exp(-2 pi 40 t): 1e-54
      EXPECT_NEAR(out, std::abs(gain) * std::cos(angle + std::arg(gain)), 1e-12);
    }
  }
}

TEST(LowPass, OnceSettledIsConstant) {
  for (const int order : {1, 2}) {
    LowPass filter(design_low_pass({50.0, order, 0.7071}, kRate_Hz).value());
    filter.settle(0.04);
    for (int k = 0; k < 100; ++k) {
      EXPECT_NEAR(filter.take(0.04), 0.04, 1e-15);
    }
  }
}

TEST(LowPass, IsRefusedOutsideItsRanges) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const LowPassParams& bad : {LowPassParams{-1.0, 2, 0.7}, LowPassParams{451.0, 2, 0.7}, LowPassParams{kNan, 2, 0.7},
                                   LowPassParams{100.0, 3, 0.7}, LowPassParams{100.0, 2, 0.0},
                                   LowPassParams{100.0, 2, kNan}}) {
    EXPECT_FALSE(design_low_pass(bad, kRate_Hz).has_value()) << bad.cut_off_Hz << ' ' << bad.order;
  }
  EXPECT_TRUE(design_low_pass({450.0, 2, 0.7}, kRate_Hz).has_value());
}

}  // namespace low_pass_test
}  // namespace farrier::control
