#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "control/model/discretise.hpp"
#include "control/model/model_analysis.hpp"
#include "plant/nominal.hpp"

namespace farrier::control {
namespace model_analysis_test {

using plant::nominal_cylinder;
using plant::nominal_load;
using plant::nominal_point;
using plant::Output;

constexpr std::uint64_t kSeed = 2014;
constexpr int kPoints = 2400;

TEST(OperatingPoints, LieBetweenTenAndAHundredAndNinetyPercentOfTheNominalOnes) {
  const plant::ActuatorParams p = nominal_cylinder();
  const auto points = operating_points(p, plant::kNominalVelocity_m_s, kPoints, kSeed);
  ASSERT_EQ(points.size(), static_cast<std::size_t>(kPoints));
  const double load_Pa = p.area_b / p.area_a * p.supply_pressure_Pa;
  double least[4] = {1.0, 1.0, 1.0, 1.0};
  double most[4] = {-1.0, -1.0, -1.0, -1.0};
  for (const plant::OperatingPoint& point : points) {
    const double share[4] = {point.position / 0.04 - 1.0, point.velocity / plant::kNominalVelocity_m_s,
                             point.load_pressure_Pa / load_Pa, point.valve_current_A / p.valve_current_max_A};
    for (int k = 0; k < 4; ++k) {
      least[k] = std::min(least[k], share[k]);
      most[k] = std::max(most[k], share[k]);
    }
    EXPECT_GE(point.valve_current_A * point.valve_sign, 0.0);
  }
  // 2400 uniform draws leave at most a hundredth of the range empty at an end, but for one set in 1e10.
  for (int k = 0; k < 4; ++k) {
    EXPECT_GE(least[k], -0.9) << k;
    EXPECT_LE(most[k], 0.9) << k;
    EXPECT_LE(least[k], -0.88) << k;
    EXPECT_GE(most[k], 0.88) << k;
  }
}

TEST(OperatingPoints, AreTheSameForTheSameSeed) {
  const auto points = operating_points(nominal_cylinder(), 1.2, 10, kSeed);
  const auto more = operating_points(nominal_cylinder(), 1.2, 20, kSeed);
  const auto others = operating_points(nominal_cylinder(), 1.2, 10, kSeed + 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i].position, more[i].position);
    EXPECT_EQ(points[i].valve_current_A, more[i].valve_current_A);
    EXPECT_NE(points[i].position, others[i].position);
  }
}

TEST(DegreeOfNonlinearity, MovesTheLowFrequenciesAndLeavesTheirFallAtHighOnes) {
  // Fig. 4.7. Every point falls by 20 dB per decade far above its poles, the fastest of which (an open valve at a low
  // drop, 1e4 1/s) still counts (1e4 / 6e5)^2 / 2 at 100 kHz: 0.002 dB.
  constexpr double kTolerance_dB = 0.01;
  const auto points = operating_points(nominal_cylinder(), plant::kNominalVelocity_m_s, kPoints, kSeed);
  const double frequencies[] = {0.5, 1e5, 1e6};
  const auto rows = responses_at_points(nominal_cylinder(), nominal_load(), points, frequencies);
  ASSERT_EQ(rows.size(), points.size());
  double least_dB = INFINITY;
  double most_dB = -INFINITY;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), 3u);
    EXPECT_NEAR(decibel(rows[i][1]) - decibel(rows[i][2]), 20.0, kTolerance_dB) << i;
    least_dB = std::min(least_dB, decibel(rows[i][0]));
    most_dB = std::max(most_dB, decibel(rows[i][0]));
  }
  EXPECT_GT(most_dB - least_dB, 20.0);
  EXPECT_EQ(rows[17][0],
            response(load_cell_system(nominal_cylinder(), nominal_load(), points[17], Output::kLoadCellForce), 0.5));
}

TEST(DegreeOfNonlinearity, AnOpenValveDampsTheResonanceAndRetractingRespondsLess) {
  // Section 4.3.1, Fig. 4.6.
  const auto peak = [](double current_A, double sign) {
    plant::OperatingPoint point = nominal_point(sign);
    point.valve_current_A = current_A;
    const SingleInOut<3> system = load_cell_system(nominal_cylinder(), nominal_load(), point, Output::kLoadCellForce);
    double most = 0.0;
    for (const double f : logarithmic_grid(60.0, 400.0, 200)) {
      most = std::max(most, std::abs(response(system, f)));
    }
    return most;
  };
  EXPECT_GT(peak(0.0, 1.0), 2.0 * peak(0.01, 1.0));
  EXPECT_GT(peak(0.01, 1.0), peak(0.01, -1.0));
}

TEST(LoadSweep, AHeavierLoadResonatesLowerAndHigher) {
  // Section 4.3.2, Fig. 4.8: to lower frequency and greater magnitude with every kilogram, 38 Hz and 160 dB at last.
  const std::vector<double> masses = logarithmic_grid(kMassRange_kg.low, kMassRange_kg.high, 20);
  double frequency_Hz = INFINITY;
  double magnitude = 0.0;
  for (const double mass : masses) {
    const auto load = with(nominal_load(), LoadParameter::kMass, mass);
    const auto peak = resonance(
        load_cell_system(nominal_cylinder(), load, nominal_point(1.0), Output::kLoadCellForce), 15.0, 1000.0);
    ASSERT_TRUE(peak.has_value()) << mass;
    EXPECT_LT(peak->frequency_Hz, frequency_Hz);
    EXPECT_GT(peak->magnitude, magnitude);
    frequency_Hz = peak->frequency_Hz;
    magnitude = peak->magnitude;
  }
  // Read from the figure, to the width of its lines.
  EXPECT_NEAR(frequency_Hz, 38.0, 1.0);
  EXPECT_NEAR(decibel(magnitude), 160.0, 1.0);
}

TEST(LoadSweep, FrictionActsAtLowFrequencyAndTheSpringThereToo) {
  const std::vector<double> frequencies = logarithmic_grid(0.1, 2000.0, 50);
  const auto spread = [&](LoadParameter parameter, Range range, std::size_t k) {
    const double values[] = {range.low, range.high};
    const auto rows = responses_to_load(nominal_cylinder(), nominal_load(), nominal_point(1.0), parameter, values,
                                        frequencies);
    return std::abs(decibel(rows[1][k]) - decibel(rows[0][k]));
  };
  const std::size_t last = frequencies.size() - 1;
  EXPECT_GT(spread(LoadParameter::kDamping, kDampingRange_Ns_m, 20), 6.0);
  EXPECT_LT(spread(LoadParameter::kDamping, kDampingRange_Ns_m, last), 1.0);
  EXPECT_GT(spread(LoadParameter::kStiffness, kStiffnessRange_N_m, 0), 6.0);
  EXPECT_LT(spread(LoadParameter::kStiffness, kStiffnessRange_N_m, last), 0.1);
}

TEST(PoleLoci, AreTheSampledPolesOfEveryMassWithEveryDamping) {
  const double masses[] = {1.0, 10.0, 127.0};
  const double dampings[] = {0.0, 2000.0};
  const double period_s = 1e-3;
  const auto loci =
      pole_loci(nominal_cylinder(), nominal_load(), nominal_point(1.0), masses, dampings, period_s);
  ASSERT_EQ(loci.size(), 6u);
  for (const PolesOfLoad& at : loci) {
    auto load = with(nominal_load(), LoadParameter::kMass, at.mass);
    load.damping = at.damping;
    const SmallSpectrum continuous =
        poles(load_cell_system(nominal_cylinder(), load, nominal_point(1.0), Output::kLoadCellForce));
    // z = exp(s T), to the rounding of the exponential and of the eigenvalues.
    for (const std::complex<double>& z : at.poles) {
      double nearest = INFINITY;
      for (const std::complex<double>& s : continuous) {
        nearest = std::min(nearest, std::abs(z - std::exp(s * period_s)));
      }
      EXPECT_LT(nearest, 1e-9) << at.mass << " kg, " << at.damping << " Ns/m";
      EXPECT_LE(std::abs(z), 1.0 + 1e-9);
    }
  }
  // Fig. 4.10: friction pulls the oscillating pair inward.
  EXPECT_LT(std::abs(loci[5].poles[1]), std::abs(loci[4].poles[1]));
}

TEST(Sampled, OfFourStatesIsThatOfThreeAndOneBesides) {
  Eigen::Matrix3d a;
  a << 0.0, 1.0, 0.0, -2148.0, -70.0, 0.1, 0.0, -2e7, -70.0;
  const Eigen::Vector3d b{0.0, 0.0, 7e8};
  plant::StateSpace<4> beside;
  beside.a.topLeftCorner<3, 3>() = a;
  beside.b.head<3>() = b;
  beside.a(3, 3) = -200.0;
  beside.b[3] = 3.0;
  const double period_s = 1e-3;
  const SampledModel<4> four = discretise(beside, period_s);
  const DiscreteModel three = discretise(a, b, period_s);
  constexpr double kTolerance = 1e-13;
  EXPECT_TRUE((four.a.topLeftCorner<3, 3>().isApprox(three.a, kTolerance)));
  EXPECT_TRUE(four.b.head<3>().isApprox(three.b, kTolerance));
  EXPECT_NEAR(four.a(3, 3), std::exp(-0.2), kTolerance);
  EXPECT_NEAR(four.b[3], 3.0 * (1.0 - std::exp(-0.2)) / 200.0, kTolerance);
  EXPECT_EQ((four.a.topRightCorner<3, 1>().norm()), 0.0);
}

TEST(Sampled, OfTheFullModelOverTwoPeriodsIsTwiceThatOverOne) {
  const SingleInOut<4> system = full_system(nominal_cylinder(), nominal_load(), plant::nominal_chamber_point(1.0),
                                            Output::kLoadCellForce);
  const SingleInOut<4> one = sampled(system, 5e-4);
  const SingleInOut<4> two = sampled(system, 1e-3);
  const Eigen::Vector4d unit = plant::nominal_state_divisors(nominal_cylinder());
  const Eigen::Matrix4d found = unit.cwiseInverse().asDiagonal() * (two.a - one.a * one.a) * unit.asDiagonal();
  const Eigen::Vector4d input = unit.cwiseInverse().asDiagonal() * (two.b - one.a * one.b - one.b) * 0.01;
  constexpr double kTolerance = 1e-12;  // rounding of some ten products of normalised matrices of norm ~10
  EXPECT_LT(found.cwiseAbs().maxCoeff(), kTolerance);
  EXPECT_LT(input.cwiseAbs().maxCoeff(), kTolerance);
}

}  // namespace model_analysis_test
}  // namespace farrier::control
