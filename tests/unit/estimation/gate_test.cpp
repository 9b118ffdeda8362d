// Which samples may teach: excitation over a window, and frequencies.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <deque>
#include <limits>
#include <numbers>

#include "estimation/excitation_gate.hpp"
#include "estimation/sliding_dft.hpp"
#include "data.hpp"
#include "tests/support/allocation_guard.hpp"
#include "tests/support/dense_solvers.hpp"

namespace farrier::estimation {
namespace gate_test {

using testing::normal;

constexpr int kWindow = 48;
constexpr double kRounding = 1e-12;  // of 2 N additions of terms of size 1

double direct_power(const std::deque<double>& window, int k) {
  std::complex<double> sum = 0.0;
  for (std::size_t n = 0; n < window.size(); ++n) {
    sum += window[n] * std::polar(1.0, -2.0 * std::numbers::pi * k * static_cast<double>(n) / kWindow);
  }
  return std::norm(sum);
}

TEST(SlidingDft, IsTheTransformOfTheLastWindowAtEveryTick) {
  SlidingDft dft(kWindow);
  EXPECT_EQ(dft.bins(), kWindow / 2 - 1);
  std::deque<double> window;
  for (int k = 0; k < 5 * kWindow; ++k) {
    const double sample = normal<1>(1, "signal", k)(0);
    dft.take(sample);
    window.push_back(sample);
    if (window.size() > kWindow) {
      window.pop_front();
    }
    EXPECT_EQ(dft.full(), k + 1 >= kWindow);
    if (window.size() == kWindow) {
      for (int bin = 1; bin <= dft.bins(); ++bin) {
        ASSERT_NEAR(dft.power(bin), direct_power(window, bin), kRounding * kWindow * kWindow) << k << " " << bin;
      }
    }
  }
}

TEST(SlidingDft, ForgetsRoundingAndAHugeSample) {
  SlidingDft dft(kWindow), clean(kWindow);
  dft.take(1e40);
  clean.take(0.0);
  for (int k = 0; k < 2 * kWindow; ++k) {
    dft.take(normal<1>(2, "signal", k)(0));
    clean.take(normal<1>(2, "signal", k)(0));
  }
  for (int bin = 1; bin <= dft.bins(); ++bin) {
    EXPECT_NEAR(dft.power(bin), clean.power(bin), kRounding * kWindow * kWindow);
  }
  for (int k = 0; k < 1'000'000; ++k) {
    dft.take(k % 2 == 0 ? 1.0 : -1.0);  // between the bins: every power is 0
  }
  for (int bin = 1; bin <= dft.bins(); ++bin) {
    EXPECT_LT(dft.power(bin), kRounding * kWindow * kWindow);
  }
}

TEST(SpectrumGate, CountsTheFrequenciesThatAreThere) {
  SpectrumGate gate({.window_ticks = kWindow, .magnitude_min = 0.1, .frequencies_min = 2}, 4);
  const auto sines = [&](int count, double amplitude) {
    for (int n = 0; n < 2 * kWindow; ++n) {
      Eigen::Vector4d signal = Eigen::Vector4d::Zero();
      for (int k = 1; k <= count; ++k) {
        signal(k % 4) += amplitude * std::sin(2.0 * std::numbers::pi * 3 * k * n / kWindow);
      }
      gate.observe(signal);
    }
  };
  for (int count = 0; count <= 5; ++count) {
    sines(count, 0.11);
    EXPECT_EQ(gate.frequencies(), count);
    EXPECT_EQ(gate.open(), count > 2);
    sines(count, 0.09);
    EXPECT_EQ(gate.frequencies(), 0);
    EXPECT_FALSE(gate.open());
  }
}

TEST(SpectrumGate, LeavesOutThePositionOfARegressorWithoutIt) {
  SpectrumGate gate({.window_ticks = kWindow, .magnitude_min = 0.1, .frequencies_min = 2}, 3);
  for (int n = 0; n < kWindow; ++n) {
    const double sine = std::sin(2.0 * std::numbers::pi * 3 * n / kWindow);
    gate.observe({sine, sine, 0.0, 0.0});
  }
  EXPECT_EQ(gate.frequencies(), 1);
}

TEST(PersistenceGate, HasTheSingularValuesOfTheLastRegressors) {
  for (const int columns : {3, 4}) {
    PersistenceGate gate({.window_ticks = kWindow, .information_min = 30.0, .information_max = 300.0}, columns);
    Eigen::MatrixXd window = Eigen::MatrixXd::Zero(kWindow, columns);
    int open = 0;
    for (int k = 0; k < 20 * kWindow; ++k) {
      const double size = 0.1 + 3.0 * std::abs(std::sin(0.01 * k));
      const Eigen::Vector4d signal = size * normal<4>(3, "signal", k);
      gate.observe(signal);
      window.row(k % kWindow) = signal.tail(columns).transpose();
      if (k + 1 < kWindow) {
        EXPECT_FALSE(gate.open()) << "not full";
        continue;
      }
      const Eigen::VectorXd sizes = test::singular_values(window.cast<std::complex<double>>());
      const double least = std::pow(sizes.minCoeff(), 2);
      const double most = std::pow(sizes.maxCoeff(), 2);
      ASSERT_NEAR(gate.singular_values()(0), least, kRounding * most);
      ASSERT_NEAR(gate.singular_values()(1), most, kRounding * most);
      ASSERT_EQ(gate.open(), least >= 30.0 && most <= 300.0) << least << " " << most;
      open += gate.open() ? 1 : 0;
    }
    EXPECT_GT(open, kWindow);
    EXPECT_LT(open, 18 * kWindow);
  }
}

TEST(PersistenceGate, IsClosedByCollinearRegressorsHoweverLarge) {
  PersistenceGate gate({.window_ticks = kWindow, .information_min = 1e-6, .information_max = 1e9}, 4);
  for (int k = 0; k < 3 * kWindow; ++k) {
    gate.observe(10.0 * normal<1>(4, "size", k)(0) * Eigen::Vector4d(1.0, -2.0, 0.5, 3.0));
  }
  EXPECT_FALSE(gate.open());
}

ExcitationGate gate_of(GateKind kind) {
  EstimatorParams params;
  params.gate = kind;
  return ExcitationGate::create(params).value();
}

TEST(ExcitationGate, IsOpenWithoutAGateAndClosesAgainAfterAReset) {
  for (const GateKind kind : {GateKind::kNone, GateKind::kPe, GateKind::kFft}) {
    ExcitationGate gate = gate_of(kind);
    EXPECT_EQ(gate.open(), kind == GateKind::kNone);
    for (int k = 0; k < 300; ++k) {
      gate.observe(normal<4>(5, "signal", k));
    }
    EXPECT_TRUE(gate.open());
    gate.reset();
    EXPECT_EQ(gate.open(), kind == GateKind::kNone);
  }
}

TEST(ExcitationGate, DoesNotAllocateAndSurvivesWhatASampleMayBe) {
  for (const GateKind kind : {GateKind::kPe, GateKind::kFft}) {
    ExcitationGate gate = gate_of(kind);
    int open = 0;
    const test::AllocationGuard guard;
    for (int k = 0; k < 5000; ++k) {
      const double size = k % 700 < 10 ? 1e40 : 1e-3;
      gate.observe(size * Eigen::Vector4d(k % 3 - 1.0, k % 5 - 2.0, k % 7 - 3.0, k % 11 - 5.0));
      open += gate.open() ? 1 : 0;
    }
    EXPECT_EQ(guard.allocations(), 0u);
    EXPECT_GT(open, 0) << "it opens again";
    gate.reset();
  }
}

TEST(ExcitationGate, RefusesSettingsOutOfRangeByName) {
  const auto refusal = [](GateKind kind, const PersistenceParams& pe, const SpectrumParams& fft) {
    EstimatorParams params;
    params.gate = kind;
    params.pe = pe;
    params.fft = fft;
    const auto gate = ExcitationGate::create(params);
    return gate ? std::string() : gate.error().message;
  };
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const auto pe = [&](const PersistenceParams& p) { return refusal(GateKind::kPe, p, {}); };
  const auto fft = [&](const SpectrumParams& p) { return refusal(GateKind::kFft, {}, p); };
  EXPECT_EQ(pe({}) + fft({}), "");
  EXPECT_NE(pe({.window_ticks = 7}).find("pe.window_ticks"), std::string::npos);
  EXPECT_NE(pe({.window_ticks = 4097}).find("pe.window_ticks"), std::string::npos);
  EXPECT_NE(pe({.information_min = kNaN}).find("pe.information_min"), std::string::npos);
  EXPECT_NE(pe({.information_min = 2.0, .information_max = 1.0}).find("pe.information_max"), std::string::npos);
  EXPECT_NE(fft({.window_ticks = 63}).find("fft.window_ticks"), std::string::npos);
  EXPECT_NE(fft({.magnitude_min = kNaN}).find("fft.magnitude_min"), std::string::npos);
  EXPECT_NE(fft({.window_ticks = 16, .frequencies_min = 21}).find("fft.frequencies_min"), std::string::npos);
}

}  // namespace gate_test
}  // namespace farrier::estimation
