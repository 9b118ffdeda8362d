// Errata of Hubacher (2014), Chapters 2 to 4 and Appendix A: the printed form is shown to be wrong and the corrected
// one right. docs/errata.md says which is which.

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <complex>

#include "plant/hydraulic_joint.hpp"
#include "thesis_rig.hpp"
#include "tests/support/dense_solvers.hpp"

namespace farrier::thesis {
namespace thesis_errata_models_test {

/// Largest natural frequency of a model's oscillating modes, Hz.
template <class Matrix>
double resonance_Hz(const Matrix& a) {
  double largest = 0.0;
  const Eigen::VectorXcd poles = test::eigenvalues(a);
  for (const auto& pole : poles) {
    if (pole.imag() > 0.0) {
      largest = std::max(largest, std::abs(pole) / (2.0 * kPi));
    }
  }
  return largest;
}

/// (3.51a) with row 2 set right, at the nominal point.
Eigen::Matrix3d load_cell_model(double mass) {
  const auto p = cylinder();
  const auto l = load();
  const double k3 = load_pressure_rate(0.04, 0.0, 0.0, 0.0, 1.0).velocity;
  const double total_mass = mass + p.piston_mass;
  Eigen::Matrix3d a;
  a << 0.0, 1.0, 0.0,  //
      -l.stiffness / total_mass, -l.damping / total_mass, 1.0 / total_mass, p.piston_damping * l.stiffness / mass,
      p.piston_damping * l.damping / mass + p.area_a * k3, -p.piston_damping / mass;
  return a;
}

TEST(ThesisErrata, TotalForceNeedsVelocity) {  // (2.41)
  auto joint =
      plant::HydraulicJoint::create(cylinder(), load(), plant::equilibrium(cylinder(), load(), 0.04, 0.0)).value();
  double largest_misfit = 0.0;
  double printed_misfit = 0.0;
  double largest_force = 0.0;
  for (int tick = 0; tick < 50; ++tick) {
    joint.step(tick < 25 ? 1e-3 : -1e-3, 0.0, 1e-3);
    const double friction = load().damping + cylinder().piston_damping;
    const double spring = load().stiffness * (joint.state().position - 0.04);
    const double total = (load().mass + cylinder().piston_mass) * joint.acceleration();
    const double without_friction = joint.hydraulic_force() - spring;
    largest_misfit = std::max(largest_misfit, std::abs(total - (without_friction - friction * joint.state().velocity)));
    printed_misfit = std::max(printed_misfit, std::abs(total - (without_friction - friction * joint.acceleration())));
    largest_force = std::max(largest_force, std::abs(joint.hydraulic_force()));
  }
  EXPECT_LT(largest_misfit, 1e-9 * largest_force);
  EXPECT_GT(printed_misfit, 10.0 * largest_force);
}

TEST(ThesisErrata, TotalForceRateNeedsTheThirdDerivative) {  // (2.43)
  // x = X sin(w t) prescribed: F_t' = M x''', F_s' = m_l x''' + d_l x'' + C x'.
  const double w = 2.0 * kPi * 5.0;
  const double x = 0.01;
  for (const double phase : {0.3, 1.1, 2.0, 4.0}) {
    const double velocity = x * w * std::cos(phase);
    const double acceleration = -x * w * w * std::sin(phase);
    const double jerk = -x * w * w * w * std::cos(phase);
    const double total_rate = (load().mass + cylinder().piston_mass) * jerk;
    const double cell_rate = load().mass * jerk + load().damping * acceleration + load().stiffness * velocity;
    const double others = cell_rate - load().stiffness * velocity - load().damping * acceleration;
    const double scale = std::abs(cell_rate) + std::abs(total_rate);
    EXPECT_NEAR(others + cylinder().piston_mass * jerk, total_rate, kRounding * scale);
    EXPECT_GT(std::abs(others + cylinder().piston_mass * acceleration - total_rate), 1e-3 * scale);
  }
}

TEST(ThesisErrata, TotalForceIsNotTheLoadCellForceAtWalkingFrequencies) {  // (2.44)
  // Without springs F_t / F_s = M s / (m_l s + d_l).
  const auto ratio = [](double frequency_Hz) {
    const std::complex<double> s(0.0, 2.0 * kPi * frequency_Hz);
    return std::abs((load().mass + cylinder().piston_mass) * s / (load().mass * s + load().damping));
  };
  EXPECT_NEAR(ratio(2.0), 0.182, 0.001);
  EXPECT_NEAR(ratio(4.0), 0.348, 0.001);
  EXPECT_NEAR(ratio(100.0), 1.0, 0.03);
}

TEST(ThesisErrata, CylinderForceOf3200NewtonBelongsTo159Bar) {  // Footnote 1 of 3.1, 4.2
  const auto p = cylinder();
  EXPECT_NEAR(p.area_a * p.supply_pressure_Pa, 5026.5, 0.1);
  EXPECT_NEAR(p.area_b * p.supply_pressure_Pa, 3063.1, 0.1);
  EXPECT_NEAR(3200.0 / p.area_a, 159.2e5, 0.1e5);
}

TEST(ThesisErrata, FullModelOfTheNominalPointHasTwoEntriesInTheVelocityColumn) {  // (3.8a)
  const auto p = cylinder();
  const auto model = full_model(nominal_state(), 0.0, 1.0);
  const double v_a = p.line_volume_m3 + 0.5 * p.stroke * p.area_a;
  const double v_b = p.line_volume_m3 + 0.5 * p.stroke * p.area_b;
  Eigen::Matrix<double, 2, 4> right = Eigen::Matrix<double, 2, 4>::Zero();
  right(0, 1) = -p.bulk_modulus_Pa * p.area_a / v_a;
  right(1, 1) = p.bulk_modulus_Pa * p.area_b / v_b;
  EXPECT_LT((model.a.bottomRows<2>() - right).norm(), kRounding * right.norm());
  EXPECT_GT(std::abs(right(0, 1) / (-p.bulk_modulus_Pa * p.area_a)), 1e4);  // the entry printed in row 3
}

TEST(ThesisErrata, InputMatrixDependsOnTheSignOfTheValveAtTheNominalPointToo) {  // text after (3.8d)
  const auto plus = full_model(nominal_state(), 0.0, 1.0);
  const auto minus = full_model(nominal_state(), 0.0, -1.0);
  EXPECT_LT((plus.a - minus.a).norm(), kRounding * plus.a.norm());
  const double ratio = std::sqrt(alpha(cylinder()));
  EXPECT_NEAR(minus.b(2) / plus.b(2), ratio, kRounding);
  EXPECT_NEAR(minus.b(3) / plus.b(3), ratio, kRounding);
  EXPECT_NEAR(ratio, 0.781, 0.001);
}

TEST(ThesisErrata, ModelsDoNotGiveOneTransferFunctionAtTheNominalPoint) {  // 4.2.1
  // Far above the resonance F_s -> F_h = A_p p_a - alpha A_p p_b = (rate per ampere) / s in both models.
  const auto p = cylinder();
  for (const double sign : {1.0, -1.0}) {
    const auto full = full_model(nominal_state(), 0.0, sign);
    const double rate = p.area_a * full.b(2) - p.area_b * full.b(3);
    const double simple = p.area_a * load_pressure_rate(0.04, 0.0, 0.0, 0.0, sign).current;
    EXPECT_NEAR(decibels(simple / rate), -0.53, 0.01) << sign;
  }
}

TEST(ThesisErrata, PrintedRowTwoOfTheLoadCellModelLosesTheResonance) {  // (3.51a)
  const double full = resonance_Hz(full_model(nominal_state(), 0.0, 1.0).a);
  const double mass = load().mass;
  const double total_mass = mass + cylinder().piston_mass;
  EXPECT_NEAR(resonance_Hz(load_cell_model(mass)) / full, 1.0, 1e-3);
  Eigen::Matrix3d printed = load_cell_model(mass);
  printed.row(1) << -load().stiffness / total_mass, -(load().damping + cylinder().piston_damping) / total_mass,
      cylinder().area_a / total_mass;
  EXPECT_LT(resonance_Hz(printed), 0.1 * full);
}

TEST(ThesisErrata, DenominatorAsPrintedIsUnstableWithAnOpenValve) {  // (4.1)-(4.3)
  const auto p = cylinder();
  const auto l = load();
  const double total_mass = l.mass + p.piston_mass;
  const double friction = l.damping + p.piston_damping;
  const auto k = load_pressure_rate(0.03, 0.2, 30e5, 5e-3, 1.0);
  Eigen::Matrix3d a;  // (A.23)
  a << 0.0, 1.0, 0.0, -l.stiffness / total_mass, -friction / total_mass, p.area_a / total_mass, k.position, k.velocity,
      k.pressure;
  for (const std::complex<double> s : {std::complex<double>(0.0, 300.0), std::complex<double>(-20.0, 1500.0)}) {
    const Eigen::Matrix3cd pencil = s * Eigen::Matrix3cd::Identity() - a.cast<std::complex<double>>();
    const std::complex<double> corrected = total_mass * s * s * s + (friction - total_mass * k.pressure) * s * s +
                                           (l.stiffness - friction * k.pressure - p.area_a * k.velocity) * s -
                                           l.stiffness * k.pressure - p.area_a * k.position;
    EXPECT_LT(std::abs(total_mass * pencil.determinant() - corrected), 1e3 * kRounding * std::abs(corrected));
  }
  // A third-order polynomial with a positive leading and a negative second coefficient has a root to the right.
  EXPECT_LT(friction + total_mass * k.k_pl, 0.0);
  EXPECT_LT(test::eigenvalues(a).real().maxCoeff(), 0.0);
}

TEST(ThesisErrata, FiguresFourFourAndFourFiveAreNotDrawnAtSteadyStates) {  // 4.2.1, (3.13)
  const auto p = cylinder();
  // 1 m/s with a shut valve: chamber a loses its pressure in less than half a period of 1 ms.
  State<double> moving = nominal_state();
  moving(1) = 1.0;
  const auto rate = full_rate<double>(moving, 0.0, 1.0);
  EXPECT_NEAR(rate(2), -22.8e9, 0.1e9);
  EXPECT_LT(moving(2) / -rate(2), 0.5e-3);
  // 30 % open at load pressure zero: by (3.15), (3.20) the piston moves, and not at zero as the figure's point says.
  const double ratio = alpha(p);
  const double steady =
      p.valve_gain * 3e-3 * std::sqrt(p.supply_pressure_Pa / (1.0 + ratio * ratio * ratio)) / p.area_a;
  EXPECT_NEAR(steady, 0.450, 0.001);
}

TEST(ThesisErrata, LinesHoldAThirdOfTheOil) {  // 4.2.1, second conclusion
  const auto p = cylinder();
  const auto share = [&](double line_m3, double area) { return line_m3 / (line_m3 + 0.5 * p.stroke * area); };
  EXPECT_NEAR(share(3.4023e-6, p.area_a), 0.297, 0.001);
  EXPECT_NEAR(share(3.4023e-6, p.area_b), 0.410, 0.001);
  EXPECT_NEAR(share(6.8047e-6, p.area_b), 0.581, 0.001);  // the rig of Table A.2
}

TEST(ThesisErrata, LightLoadResonatesBelow370Hertz) {            // 4.3.2: "up to 500 Hz for light mass"
  EXPECT_NEAR(resonance_Hz(load_cell_model(127.0)), 37.2, 0.1);  // "38 Hz for heavy mass"
  EXPECT_NEAR(resonance_Hz(load_cell_model(1.0)), 366.4, 1.0);
}

TEST(ThesisErrata, OnePoleStaysAtOneWhateverMassAndFriction) {  // 4.3.2, Fig. 4.10
  for (const double mass : {1.0, 10.0, 127.0}) {
    const Eigen::Vector3cd poles = test::eigenvalues(load_cell_model(mass));
    EXPECT_LT(poles.cwiseAbs().minCoeff(), 1e-9 * poles.cwiseAbs().maxCoeff());
  }
}

TEST(ThesisErrata, SpoolIsNotFastAgainstALightLoad) {  // 2.4
  const auto lag = [](double frequency_Hz) {           // (2.19) with Table A.1
    const std::complex<double> s(0.0, 2.0 * kPi * frequency_Hz / 1570.0);
    return -degrees(std::arg(1.0 / (s * s + 2.0 * 0.5 * s + 1.0)));
  };
  EXPECT_NEAR(lag(38.0), 8.9, 0.1);
  EXPECT_NEAR(lag(200.0), 65.9, 0.2);
}

TEST(ThesisErrata, PressureDerivativeNeedsTheChambersOwnPressure) {  // (A.7)
  const auto p = cylinder();
  const State<double> point(0.03, 0.2, 60e5, 90e5);
  const double current = 4e-3;
  const double gain = -p.bulk_modulus_Pa * p.valve_gain * current / (2.0 * (p.line_volume_m3 + 0.03 * p.area_a));
  const double derivative = full_model(point, current, 1.0).a(2, 2);
  EXPECT_NEAR(derivative, gain / std::sqrt(p.supply_pressure_Pa - 60e5), kRounding * std::abs(derivative));
  EXPECT_NEAR(gain / std::sqrt(p.supply_pressure_Pa) / derivative, 0.872, 0.001);
}

TEST(ThesisErrata, DerivativesForANegativeValveAreRightAsPrinted) {  // (A.13)-(A.19)
  const auto p = cylinder();
  const State<double> s(0.03, 0.2, 60e5, 90e5);
  const double u = 4e-3;
  const auto model = full_model(s, -u, -1.0);
  const double v_a = p.line_volume_m3 + s(0) * p.area_a;
  const double v_b = p.line_volume_m3 + (p.stroke - s(0)) * p.area_b;
  const double root_a = std::sqrt(s(2) - p.return_pressure_Pa);
  const double root_b = std::sqrt(p.supply_pressure_Pa - s(3));
  const double beta = p.bulk_modulus_Pa;
  Eigen::Matrix<double, 2, 5> printed;
  printed << -beta * p.area_a / (v_a * v_a) * (-p.valve_gain * u * root_a - p.area_a * s(1)), -beta * p.area_a / v_a,
      -beta / v_a * p.valve_gain * u / (2.0 * root_a), 0.0, beta * p.valve_gain * root_a / v_a,
      beta * p.area_b / (v_b * v_b) * (p.valve_gain * u * root_b + p.area_b * s(1)), beta * p.area_b / v_b, 0.0,
      -beta / v_b * p.valve_gain * u / (2.0 * root_b), -beta * p.valve_gain * root_b / v_b;
  Eigen::Matrix<double, 2, 5> derived;
  derived << model.a.bottomRows<2>(), model.b.bottomRows<2>();
  for (int i = 0; i < printed.size(); ++i) {
    EXPECT_NEAR(printed(i), derived(i), kRounding * std::abs(derived(i))) << i;
  }
}

TEST(ThesisErrata, LinePipeVolume) {  // Tables A.1, A.2
  const auto volume = [](double length_m) { return length_m * kPi * 0.0038 * 0.0038 / 4.0; };
  EXPECT_NEAR(volume(0.3), 3.4023e-6, 1e-10);
  EXPECT_NEAR(volume(0.6), 6.8047e-6, 1e-10);
  EXPECT_NEAR(volume(0.9), 1.0207e-5, 1e-9);  // printed for 0.6 m
}

TEST(ThesisErrata, PistonMassTakesTheRingForTheRod) {  // Table A.1
  const auto p = cylinder();
  const auto mass = [&](double rod_share) { return p.area_a * (rod_share * p.stroke + 0.15) * 7860.0; };
  EXPECT_NEAR(mass(alpha(p)), 0.3141, 1e-4);                             // printed
  EXPECT_NEAR(1.0 - alpha(p), (0.010 * 0.010) / (0.016 * 0.016), 1e-4);  // the rod's section
  EXPECT_NEAR(mass(1.0 - alpha(p)), 0.2864, 1e-4);
}

}  // namespace thesis_errata_models_test
}  // namespace farrier::thesis
