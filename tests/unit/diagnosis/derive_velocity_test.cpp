#include "diagnosis/data/derive_velocity.hpp"

#include "recording.hpp"

namespace farrier::diagnosis {
namespace derive_velocity_test {

constexpr double kPeriod_s = 0.001;
constexpr double kStroke = 0.08;

/// Positions of the bench's motion at `speed` times its frequencies, seen through a sensor.
struct Motion {
  std::vector<double> position, velocity;

  Motion(std::size_t samples, double sigma, double step, double speed = 1.0) {
    const NoiseStream stream(11, "derive", "position");
    for (std::size_t i = 0; i < samples; ++i) {
      const double t = static_cast<double>(i) * kPeriod_s;
      const double x = TestBench::position(kStroke, speed * t) + sigma * stream.normal(static_cast<Tick>(i));
      position.push_back(step > 0.0 ? step * std::round(x / step) : x);
      velocity.push_back(speed * TestBench::velocity(kStroke, speed * t));
    }
  }
  double rms_error(const DerivedVelocity& derived, std::size_t margin) const {
    double sum = 0.0;
    for (std::size_t i = margin; i + margin < velocity.size(); ++i) {
      sum += std::pow(derived.velocity[i] - velocity[i], 2);
    }
    return std::sqrt(sum / static_cast<double>(velocity.size() - 2 * margin));
  }
};

TEST(WhiteNoise, IsFoundBeneathMotion) {
  for (const double sigma : {2e-6, 1e-5, 1e-4}) {
    // The estimate from n samples has a relative spread near 1 / sqrt(n / 20) for differences of order 10; the least of
    // ten orders is below the mean.
    EXPECT_NEAR(white_noise(Motion(5000, sigma, 0.0).position), sigma, 0.15 * sigma);
  }
}

TEST(WhiteNoise, IsZeroWithoutNoise) {
  EXPECT_LT(white_noise(Motion(5000, 0.0, 0.0).position), 1e-12);
  EXPECT_EQ(white_noise(std::vector<double>(100, 0.04)), 0.0);
  EXPECT_EQ(white_noise(std::vector<double>{1, 2, 1}), 0.0);
}

TEST(WhiteNoise, OfASlowSensorWithStepsIsThatOfItsSteps) {
  const double step = 1e-4;
  const double found = white_noise(Motion(5000, 0.0, step, 0.2).position);
  EXPECT_GE(found, 0.999 * step / std::sqrt(12.0));
  EXPECT_LT(found, step);
}

TEST(DeriveVelocity, IsExactForAParabolaUpToItsEnds) {
  std::vector<double> position;
  for (int i = 0; i < 100; ++i) {
    position.push_back(0.01 + 0.002 * i + 1e-5 * i * i);
  }
  const DerivedVelocity derived = derive_velocity(position, kPeriod_s);
  for (int i = 0; i < 100; ++i) {
    EXPECT_NEAR(derived.velocity[static_cast<std::size_t>(i)], (0.002 + 2e-5 * i) / kPeriod_s, 1e-9);
  }
}

TEST(DeriveVelocity, TellsItsOwnError) {
  for (const double sigma : {1e-6, 1e-5, 1e-4}) {
    const Motion motion(5000, sigma, 0.0);
    const DerivedVelocity derived = derive_velocity(motion.position, kPeriod_s);
    const double claimed = std::hypot(derived.noise, derived.bias);
    const double error = motion.rms_error(derived, 100);
    EXPECT_LT(error, 1.3 * claimed) << sigma << ", half window " << derived.half_window;
    EXPECT_GT(error, 0.5 * claimed) << sigma << ", half window " << derived.half_window;
  }
}

TEST(DeriveVelocity, TakesNearlyTheBestWindow) {
  // Slope by least squares over 2 h + 1 samples.
  const auto error_with = [](const Motion& motion, int h) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 100; i + 100 < motion.position.size(); ++i, ++count) {
      double slope = 0.0;
      for (int k = -h; k <= h; ++k) {
        slope += k * motion.position[i + static_cast<std::size_t>(k + 100) - 100];
      }
      sum += std::pow(slope * 3.0 / (h * (h + 1.0) * (2.0 * h + 1.0)) / kPeriod_s - motion.velocity[i], 2);
    }
    return std::sqrt(sum / static_cast<double>(count));
  };
  for (const double sigma : {1e-7, 2e-6, 5e-5}) {
    for (const double speed : {0.3, 1.0, 4.0}) {
      const Motion motion(5000, sigma, 0.0, speed);
      double best = error_with(motion, 1);
      for (int h = 2; h <= 100; ++h) {
        best = std::min(best, error_with(motion, h));
      }
      const DerivedVelocity derived = derive_velocity(motion.position, kPeriod_s);
      EXPECT_LT(motion.rms_error(derived, 100), 1.3 * best) << sigma << " " << speed << " " << derived.half_window;
    }
  }
}

TEST(DeriveVelocity, WidensItsWindowWithTheNoise) {
  int last = 0;
  for (const double sigma : {0.0, 1e-6, 1e-5, 1e-4}) {
    const int half = derive_velocity(Motion(5000, sigma, 0.0).position, kPeriod_s).half_window;
    EXPECT_GT(half, last) << sigma;
    last = half;
  }
}

TEST(DeriveVelocity, SmoothsTheStepsOfAnEncoder) {
  const Motion motion(5000, 0.0, 1e-5);
  const DerivedVelocity derived = derive_velocity(motion.position, kPeriod_s);
  EXPECT_LT(motion.rms_error(derived, 100), 2.0 * std::hypot(derived.noise, derived.bias));
  EXPECT_LT(motion.rms_error(derived, 100), 0.01 * 0.2);  // of a motion that runs up to 0.2 m/s and more
}

TEST(DeriveVelocity, OfFewOrRestingPositionsIsFinite) {
  for (std::size_t n = 0; n < 50; ++n) {
    const DerivedVelocity derived = derive_velocity(std::vector<double>(n, 0.04), kPeriod_s);
    ASSERT_EQ(derived.velocity.size(), n);
    for (const double velocity : derived.velocity) {
      EXPECT_NEAR(velocity, 0.0, 1e-12);
    }
    EXPECT_EQ(derived.noise, 0.0);
  }
}

}  // namespace derive_velocity_test
}  // namespace farrier::diagnosis
