#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "control/model/force_transfer.hpp"
#include "control/model/model_analysis.hpp"
#include "tests/unit/plant/linear_points.hpp"

namespace farrier::control {
namespace transfer_function_test {

using Complex = std::complex<double>;
using plant::Output;
using plant::test::draw;
using plant::test::Draw;
using plant::test::kPoints;

constexpr Complex kI{0.0, 1.0};

Complex s_of(double frequency_Hz) { return 2.0 * std::numbers::pi * frequency_Hz * kI; }

/// omega^2 / (s^2 + 2 zeta omega s + omega^2) and, behind it, a lag far above.
SingleInOut<3> oscillator(double omega, double zeta) {
  SingleInOut<3> system;
  system.a << 0.0, 1.0, 0.0, -omega * omega, -2.0 * zeta * omega, 0.0, 0.0, 0.0, -1e6 * omega;
  system.b << 0.0, omega * omega, 0.0;
  system.c << 1.0, 0.0, 0.0;
  return system;
}

TEST(ForceTransfers, AreThoseOfTheLoadPressureModel) {
  // Rounding of the quotient's polynomials, whose terms cancel most at the resonance, by 1 / (2 zeta) < 1e3.
  constexpr double kTolerance = 1e-11;
  const std::vector<double> frequencies = logarithmic_grid(0.05, 2000.0, 30);
  for (int i = 0; i < kPoints; ++i) {
    const Draw one = draw(i);
    const ForceTransfers of =
        force_transfers(one.actuator, one.load, load_pressure_coefficients(one.actuator, one.point));
    const std::pair<const Rational<3>*, Output> pairs[] = {{&of.load_cell, Output::kLoadCellForce},
                                                           {&of.hydraulic, Output::kHydraulicForce},
                                                           {&of.total, Output::kTotalForce}};
    for (const auto& [quotient, output] : pairs) {
      const SingleInOut<3> system = load_pressure_system(one.actuator, one.load, one.point, output);
      // Where the row's terms cancel (F_t at low frequency), roundings are of the hydraulic force.
      const SingleInOut<3> whole = load_pressure_system(one.actuator, one.load, one.point, Output::kHydraulicForce);
      for (const double f : frequencies) {
        const Complex wanted = response(system, f);
        EXPECT_LT(std::abs(quotient->at(s_of(f)) - wanted),
                  kTolerance * std::abs(wanted) + 1e-13 * std::abs(response(whole, f)))
            << "point " << i << " at " << f << " Hz";
      }
    }
  }
}

TEST(ForceTransfers, MeetAtHighAndPartAtLowFrequency) {
  // Section 4.2, Fig. 4.3: above 100 Hz the three are one; at low frequency F_t has two zeros at the origin.
  const ForceTransfers of =
      force_transfers(plant::nominal_cylinder(), plant::nominal_load(),
                      load_pressure_coefficients(plant::nominal_cylinder(), plant::nominal_point(1.0)));
  const auto apart = [&](const Rational<3>& other, double f) {
    return std::abs(other.at(s_of(f)) / of.load_cell.at(s_of(f)) - 1.0);
  };
  EXPECT_LT(apart(of.hydraulic, 1000.0), 0.02);
  EXPECT_LT(apart(of.total, 1000.0), 0.02);
  EXPECT_GT(apart(of.total, 1.0), 0.95);
}

TEST(TransferFunction, AsAQuotientRespondsAsTheStateSpace) {
  constexpr double kTolerance = 1e-9;  // of a fourth-order polynomial at the resonance's 1 / (2 zeta) < 1e3, below
  const std::vector<double> frequencies = logarithmic_grid(0.5, 2000.0, 20);
  for (int i = 0; i < kPoints; ++i) {
    const Draw one = draw(i);
    for (const Output output : {Output::kPosition, Output::kVelocity, Output::kLoadCellForceWithInertia}) {
      const SingleInOut<4> system = full_system(one.actuator, one.load, one.chambers, output);
      const Rational<4> quotient = transfer_function(system);
      EXPECT_EQ(quotient.denominator[4], 1.0);
      for (const double f : frequencies) {
        const Complex wanted = response(system, f);
        EXPECT_LT(std::abs(quotient.at(s_of(f)) - wanted), kTolerance * std::abs(wanted)) << i << " at " << f << " Hz";
      }
    }
  }
}

TEST(TransferFunction, HasADirectPart) {
  SingleInOut<3> system = oscillator(100.0, 0.1);
  const Complex without = response(system, 20.0);
  system.d = 0.75;
  EXPECT_LT(std::abs(response(system, 20.0) - (without + 0.75)), 1e-15);
  EXPECT_LT(std::abs(transfer_function(system).at(s_of(20.0)) - (without + 0.75)), 1e-12);
}

TEST(Poles, AreTheRootsOfTheDenominator) {
  for (int i = 0; i < kPoints; ++i) {
    const Draw one = draw(i);
    const SingleInOut<3> system = load_cell_system(one.actuator, one.load, one.point, Output::kLoadCellForce);
    const SmallSpectrum p = poles(system);
    ASSERT_EQ(p.size(), 3);
    const Rational<3> quotient = transfer_function(system);
    // s^3 - (sum) s^2 + (sum of pairs) s - (product), each to the rounding of its terms.
    const double size = p.cwiseAbs().maxCoeff();
    constexpr double kTolerance = 1e-12;
    EXPECT_NEAR((p(0) + p(1) + p(2)).real(), -quotient.denominator[2], kTolerance * size);
    EXPECT_NEAR((p(0) * p(1) + p(1) * p(2) + p(2) * p(0)).real(), quotient.denominator[1], kTolerance * size * size);
    EXPECT_NEAR((p(0) * p(1) * p(2)).real(), -quotient.denominator[0], kTolerance * size * size * size);
    EXPECT_GE(p(0).real(), p(1).real());
    EXPECT_GE(p(1).real(), p(2).real());
  }
}

TEST(Zeros, OfTheForcesAreThoseOfTheirNumerators) {
  for (int i = 0; i < kPoints; ++i) {
    const Draw one = draw(i);
    // (4.1) M s^2 + d_l s + C, whatever the operating point; (4.2) the same with B.
    const double M = one.load.mass + one.actuator.piston_mass;
    for (const auto& [output, damping] :
         {std::pair(Output::kLoadCellForce, one.load.damping),
          std::pair(Output::kHydraulicForce, one.load.damping + one.actuator.piston_damping)}) {
      const SmallSpectrum z = zeros(load_pressure_system(one.actuator, one.load, one.point, output));
      ASSERT_EQ(z.size(), 2) << i;
      const Complex root = std::sqrt(Complex(damping * damping - 4.0 * M * one.load.stiffness));
      const double size = std::abs(damping) / M + std::sqrt(one.load.stiffness / M);
      // A double root moves by the square root of a rounding; eigenvalues of a matrix with poles up to 1e4 1/s.
      const double apart = std::abs(root) / M;
      const double tolerance = std::min(1e-6 * size, 1e-9 * size * size / apart);
      EXPECT_LT(std::abs(z(0) - (-damping + root) / (2.0 * M)), tolerance) << i;
      EXPECT_LT(std::abs(z(1) - (-damping - root) / (2.0 * M)), tolerance) << i;
    }
    // (4.3) M s^2: a double root at the origin.
    const SmallSpectrum z = zeros(load_pressure_system(one.actuator, one.load, one.point, Output::kTotalForce));
    ASSERT_EQ(z.size(), 2) << i;
    EXPECT_LT(z.cwiseAbs().maxCoeff(), 1e-3) << i;
  }
}

TEST(Zeros, AreAsManyAsTheRelativeDegreeLeaves) {
  const Draw one = draw(3);
  EXPECT_EQ(zeros(load_pressure_system(one.actuator, one.load, one.point, Output::kPosition)).size(), 0);
  const SmallSpectrum velocity = zeros(load_pressure_system(one.actuator, one.load, one.point, Output::kVelocity));
  ASSERT_EQ(velocity.size(), 1);
  EXPECT_LT(std::abs(velocity(0)), 1e-9);
  EXPECT_EQ(zeros(full_system(one.actuator, one.load, one.chambers, Output::kPosition)).size(), 1);
  EXPECT_EQ(zeros(full_system(one.actuator, one.load, one.chambers, Output::kLoadCellForce)).size(), 3);
  EXPECT_EQ(zeros(oscillator(10.0, 0.1)).size(), 1);  // it cancels the lag that the output does not read
  SingleInOut<3> deaf = oscillator(10.0, 0.1);
  deaf.c << 0.0, 0.0, 1.0;
  EXPECT_EQ(zeros(deaf).size(), 0);
}

TEST(Zeros, NullTheResponseOfSampledAndDirectSystemsToo) {
  for (int i = 0; i < kPoints; ++i) {
    const Draw one = draw(i);
    SingleInOut<4> system = sampled(full_system(one.actuator, one.load, one.chambers, Output::kLoadCellForce), 1e-3);
    for (const double direct : {0.0, 1e5}) {
      system.d = direct;
      const SmallSpectrum z = zeros(system);
      ASSERT_EQ(z.size(), direct == 0.0 ? 3 : 4) << i;
      const Rational<4> quotient = transfer_function(system);
      for (const Complex& zero : z) {
        Complex value = 0.0;
        double size = 0.0;
        for (int k = 4; k >= 0; --k) {
          value = value * zero + quotient.numerator[k];
          size = size * std::abs(zero) + std::abs(quotient.numerator[k]);
        }
        EXPECT_LT(std::abs(value), 1e-9 * size) << i << " zero " << zero;
      }
    }
  }
}

TEST(Resonance, OfAnOscillatorIsWhereTheTextbookHasIt) {
  for (const double zeta : {0.001, 0.01, 0.1, 0.3, 0.6}) {
    const double omega = 400.0;
    const auto peak = resonance(oscillator(omega, zeta), 1.0, 1000.0);
    ASSERT_TRUE(peak.has_value()) << zeta;
    const double wanted_Hz = omega * std::sqrt(1.0 - 2.0 * zeta * zeta) / (2.0 * std::numbers::pi);
    EXPECT_NEAR(peak->frequency_Hz, wanted_Hz, 1e-6 * wanted_Hz) << zeta;
    EXPECT_NEAR(peak->magnitude, 1.0 / (2.0 * zeta * std::sqrt(1.0 - zeta * zeta)), 1e-6 * peak->magnitude) << zeta;
  }
}

TEST(Resonance, IsEmptyWithoutAMaximumInside) {
  EXPECT_FALSE(resonance(oscillator(400.0, 0.8), 1.0, 1000.0).has_value());  // zeta > 1 / sqrt(2): falls throughout
  EXPECT_FALSE(resonance(oscillator(400.0, 0.1), 100.0, 1000.0).has_value());  // it lies at 63 Hz
  SingleInOut<3> broken = oscillator(400.0, 0.1);
  broken.a(0, 0) = NAN;
  EXPECT_FALSE(resonance(broken, 1.0, 1000.0).has_value());
}

TEST(Responses, UnwrapToTheFullPhaseOfTheSystem) {
  const std::vector<double> frequencies = logarithmic_grid(0.01, 1e5, 400);
  EXPECT_EQ(frequencies.front(), 0.01);
  EXPECT_EQ(frequencies.back(), 1e5);
  // Valve to position: an integrator and a resonance, from -90 to -270 degrees.
  const auto values = responses(load_pressure_system(plant::nominal_cylinder(), plant::nominal_load(),
                                                     plant::nominal_point(1.0), Output::kPosition), frequencies);
  const std::vector<double> degrees = unwrapped_degrees(values);
  EXPECT_NEAR(degrees.front(), -90.0, 1.0);
  EXPECT_NEAR(degrees.back(), -270.0, 1.0);
  for (std::size_t i = 1; i < degrees.size(); ++i) {
    EXPECT_LT(std::abs(degrees[i] - degrees[i - 1]), 180.0);
    EXPECT_NEAR(std::remainder(degrees[i] - std::arg(values[i]) * 180.0 / std::numbers::pi, 360.0), 0.0, 1e-9);
  }
  EXPECT_DOUBLE_EQ(decibel(Complex(0.0, -100.0)), 40.0);
}

TEST(Responses, OfASampledSystemAreTheContinuousOnesWithTheirAliases) {
  // H_d(f) = sum_k H(f + k / T) (1 - e^(-sT)) / (s T), s = 2 pi i (f + k / T): the hold's spectrum, sampled.
  const Draw one = draw(10);
  const double period_s = 1e-3;
  const SingleInOut<4> continuous = full_system(one.actuator, one.load, one.chambers, Output::kVelocity);
  const SingleInOut<4> discrete = sampled(continuous, period_s);
  for (const double f : {1.0, 20.0, 90.0, 240.0, 499.0}) {
    Complex sum = 0.0;
    for (int k = -400; k <= 400; ++k) {
      const Complex s = s_of(f + k / period_s);
      sum += response(continuous, f + k / period_s) * (1.0 - std::exp(-s * period_s)) / (s * period_s);
    }
    // The velocity falls as f^-2, the hold as f^-1: what is left out is below 400^-2 / 2 of the largest alias.
    const Complex found = response(discrete, f);
    EXPECT_LT(std::abs(found - sum), 1e-5 * std::abs(sum)) << f;
  }
}

TEST(Normalise, ScalesTheResponseByTheDivisorsAndNoPole) {
  const SingleInOut<4> system = full_system(plant::nominal_cylinder(), plant::nominal_load(),
                                            plant::nominal_chamber_point(1.0), Output::kLoadCellForce);
  // (3.9)-(3.11)
  const SingleInOut<4> scaled = normalise<4>(system, plant::nominal_state_divisors(plant::nominal_cylinder()),
                                             plant::kNominalCurrent_A, plant::kNominalForce_N);
  for (const double f : {0.1, 10.0, 150.0}) {
    const Complex wanted = response(system, f) * plant::kNominalCurrent_A / plant::kNominalForce_N;
    EXPECT_LT(std::abs(response(scaled, f) - wanted), 1e-12 * std::abs(wanted));
  }
  EXPECT_TRUE(poles(scaled).isApprox(poles(system), 1e-9));
  EXPECT_LE(scaled.c.cwiseAbs().maxCoeff(), 1.02);  // A_p p_s / 5000 N
}

TEST(Responses, OfNonFiniteSystemsAndFrequenciesAreNotFinite) {
  const SingleInOut<3> system = oscillator(100.0, 0.1);
  EXPECT_FALSE(std::isfinite(std::abs(response(system, NAN))));
  SingleInOut<3> broken = system;
  broken.a(1, 1) = INFINITY;
  EXPECT_FALSE(std::isfinite(std::abs(response(broken, 1.0))));
  EXPECT_TRUE(poles(broken).hasNaN());
  broken = system;
  broken.a(1, 1) = NAN;
  const SmallSpectrum z = zeros(broken);
  EXPECT_TRUE(z.size() == 0 || z.hasNaN());
}

}  // namespace transfer_function_test
}  // namespace farrier::control
