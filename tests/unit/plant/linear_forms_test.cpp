#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "plant/force_dynamics.hpp"
#include "plant/linear_model.hpp"
#include "plant/nominal.hpp"
#include "linear_points.hpp"

namespace farrier::plant {
namespace linear_forms_test {

using test::complex_step;
using test::draw;
using test::Draw;
using test::kPoints;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// Entry by entry, relative to the entry; entries that are differences may err by roundings of `floor`.
template <int N>
void expect_same(const StateSpace<N>& found, const StateSpace<N>& wanted, double relative,
                 const Eigen::Matrix<double, N, N>& floor, int i) {
  for (int row = 0; row < N; ++row) {
    for (int column = 0; column < N; ++column) {
      EXPECT_NEAR(found.a(row, column), wanted.a(row, column),
                  relative * std::abs(wanted.a(row, column)) + 16.0 * kEpsilon * floor(row, column))
          << "point " << i << " row " << row << " column " << column;
    }
    EXPECT_NEAR(found.b[row], wanted.b[row], relative * std::abs(wanted.b[row])) << "point " << i << " row " << row;
  }
}

/// Sizes of the two terms whose difference a pressure's derivative with respect to position is.
double terms_by_position(const Draw& one) {
  const ActuatorParams& p = one.actuator;
  const double least = p.line_volume_m3 + 0.05 * p.stroke * p.area_b;
  return 2.0 * p.bulk_modulus_Pa * p.area_a / (least * least) *
         (p.valve_gain * std::abs(one.point.valve_current_A) * std::sqrt(p.supply_pressure_Pa) +
          p.area_a * std::abs(one.point.velocity));
}

TEST(FullModel, IsTheJacobianOfThePrintedNonlinearEquations) {
  // The orifice differs from a root by (delta / drop)^2, 1e-10 and less with delta = 1 Pa and drops above 1e5 Pa.
  constexpr double kTolerance = 1e-10;
  int extending = 0;
  for (int i = 0; i < kPoints; ++i) {
    Draw one = draw(i);
    one.actuator.laminar_pressure_Pa = 1.0;
    const double sign = one.chambers.valve_sign;
    extending += sign > 0.0;
    const State& s = one.chambers.state;
    const auto wanted = complex_step<4>(
        [&](const auto& x, const auto& u) { return test::full_rate(one.actuator, one.load, sign, x, u); },
        Eigen::Vector4d{s.position, s.velocity, s.pressure_a_Pa, s.pressure_b_Pa}, one.chambers.valve_current_A);
    Eigen::Matrix4d floor = Eigen::Matrix4d::Zero();
    floor(2, 0) = floor(3, 0) = terms_by_position(one);
    expect_same<4>(linearise_full(one.actuator, one.load, one.chambers), wanted, kTolerance, floor, i);
  }
  EXPECT_EQ(extending, kPoints / 2);
}

TEST(FullModel, IsTheJacobianOfTheSimulatedJointInItsLaminarRangeToo) {
  for (int i = 0; i < kPoints; ++i) {
    Draw one = draw(i);
    State& s = one.chambers.state;
    if (i % 4 == 0) {
      // Within a few laminar pressures of a port, on either side of it.
      s.pressure_a_Pa = one.actuator.supply_pressure_Pa + 2e5 * (i % 7 - 3);
      s.pressure_b_Pa = std::max(1e4, one.actuator.return_pressure_Pa + 2e5 * (i % 5 - 2));
    }
    const JointEquations equations(one.actuator, one.load);
    const auto rate = [&](const Eigen::Vector4d& x, double u) {
      const IntegrationState r = equations.derivative({x[0], x[1], x[2], x[3]}, equations.hold(u, 0.0));
      return Eigen::Vector4d{r.position, r.velocity, r.compression_a_Pa, r.compression_b_Pa};
    };
    const Eigen::Vector4d x{s.position, s.velocity, s.pressure_a_Pa, s.pressure_b_Pa};
    const double u = one.chambers.valve_current_A;
    if (std::abs(u) < 1e-4) {
      continue;  // differences would reach across the change of sign
    }
    const StateSpace<4> model = linearise_full(one.actuator, one.load, one.chambers);
    const Eigen::Vector4d size = rate(x, u).cwiseAbs() + Eigen::Vector4d{1.0, 1e3, 1e10, 1e10};
    // Richardson's extrapolation of central differences has the error (h / scale)^4 with scales 1 mm of stroke, 1 m/s,
    // delta = 1e5 Pa and the current. The step h is 1e-2 of them, so the error is 1e-8 of slopes that are themselves
    // within a few of the largest.
    const Eigen::Vector<double, 5> step{1e-5, 1e-2, 500.0, 500.0, 5e-7};
    constexpr double kTruncation = 1e-7;
    for (int column = 0; column < 5; ++column) {
      const auto central = [&](double h) -> Eigen::Vector4d {
        Eigen::Vector4d d = Eigen::Vector4d::Zero();
        if (column < 4) {
          d[column] = h;
        }
        const double du = column == 4 ? h : 0.0;
        return (rate(x + d, u + du) - rate(x - d, u - du)) / (2.0 * h);
      };
      const Eigen::Vector4d slope = (4.0 * central(0.5 * step[column]) - central(step[column])) / 3.0;
      const Eigen::Vector4d wanted = column < 4 ? Eigen::Vector4d(model.a.col(column)) : model.b;
      for (int row = 0; row < 4; ++row) {
        const double rounding = 64.0 * kEpsilon * size[row] / step[column];
        ASSERT_NEAR(slope[row], wanted[row], kTruncation * std::abs(wanted[row]) + rounding)
            << "point " << i << " row " << row << " column " << column;
      }
    }
  }
}

TEST(LoadPressureModel, IsTheJacobianOfThePrintedLoadPressureEquation) {
  constexpr double kTolerance = 1e-12;  // rounding of some thirty operations
  for (int i = 0; i < kPoints; ++i) {
    const Draw one = draw(i);
    const double sign = one.point.valve_sign;
    const auto wanted = complex_step<3>(
        [&](const auto& x, const auto& u) { return test::load_pressure_rate(one.actuator, one.load, sign, x, u); },
        Eigen::Vector3d{one.point.position, one.point.velocity, one.point.load_pressure_Pa}, one.point.valve_current_A);
    Eigen::Matrix3d floor = Eigen::Matrix3d::Zero();
    floor(2, 0) = terms_by_position(one);
    expect_same<3>(linearise_load_pressure(one.actuator, one.load, one.point), wanted, kTolerance, floor, i);
  }
}

TEST(LoadCellModel, IsTheLoadPressureModelInOtherStates) {
  // F_s = A_p p_l - d_p v - m_p a: a change of states T, T a T^-1 and T b.
  for (int i = 0; i < kPoints; ++i) {
    const Draw one = draw(i);
    const StateSpace<3> pressure = linearise_load_pressure(one.actuator, one.load, one.point);
    const LinearModel cell = linearise_load_cell_force(one.actuator, one.load, one.point);
    Eigen::Matrix3d change = Eigen::Matrix3d::Identity();
    change.row(2) = load_pressure_output(Output::kLoadCellForceWithInertia, one.actuator, one.load);
    const Eigen::Matrix3d inverse = change.inverse();
    const Eigen::Matrix3d sizes = change.cwiseAbs() * pressure.a.cwiseAbs() * inverse.cwiseAbs();
    const Eigen::Matrix3d difference = change * pressure.a * inverse - cell.a;
    for (int k = 0; k < 9; ++k) {
      EXPECT_LE(std::abs(difference(k)), 64.0 * kEpsilon * sizes(k)) << "point " << i << " entry " << k;
    }
    EXPECT_TRUE((change * pressure.b).isApprox(cell.b, 1e-14)) << i;
  }
}

TEST(LinearForms, WithConstantVolumesLoseTheirDependenceOnPositionAndNothingElse) {
  for (int i = 0; i < kPoints; ++i) {
    const Draw one = draw(i);
    StateSpace<4> full = linearise_full(one.actuator, one.load, one.chambers);
    full.a(2, 0) = full.a(3, 0) = 0.0;
    const StateSpace<4> full_constant = linearise_full(one.actuator, one.load, one.chambers, Volumes::kConstant);
    EXPECT_EQ(full.a, full_constant.a);
    EXPECT_EQ(full.b, full_constant.b);
    StateSpace<3> pressure = linearise_load_pressure(one.actuator, one.load, one.point);
    pressure.a(2, 0) = 0.0;
    const StateSpace<3> constant = linearise_load_pressure(one.actuator, one.load, one.point, Volumes::kConstant);
    EXPECT_EQ(pressure.a, constant.a);
    EXPECT_EQ(pressure.b, constant.b);
    // (3.48): what is left of the position in the force's rate is the spring's.
    const LinearModel cell =
        linearise_load_cell_force(one.actuator, one.load, one.point, Volumes::kConstant, PistonMass::kNeglected);
    EXPECT_DOUBLE_EQ(cell.a(2, 0), one.actuator.piston_damping * one.load.stiffness / one.load.mass);
  }
}

TEST(LinearForms, OutputRowsReadTheForcesOfTheNonlinearJoint) {
  for (int i = 0; i < kPoints; ++i) {
    Draw one = draw(i);
    one.load.equilibrium_position = 0.0;  // so that forces are linear, not only affine, in the state
    const State& s = one.chambers.state;
    const Eigen::Vector4d x{s.position, s.velocity, s.pressure_a_Pa, s.pressure_b_Pa};
    const Forces of = forces(one.actuator, one.load, s, one.chambers.valve_current_A, 0.0);
    const double tolerance = 1e-13 * (std::abs(of.hydraulic) + 2.0 * one.actuator.area_a * s.pressure_a_Pa + 2e4);
    const auto read = [&](Output output) -> double { return full_output(output, one.actuator, one.load) * x; };
    EXPECT_NEAR(read(Output::kHydraulicForce), of.hydraulic, tolerance);
    EXPECT_NEAR(read(Output::kTotalForce), of.total, tolerance);
    EXPECT_NEAR(read(Output::kLoadCellForceWithInertia), of.load_cell, tolerance);
    EXPECT_NEAR(read(Output::kLoadCellForce), of.hydraulic - one.actuator.piston_damping * s.velocity, tolerance);
    EXPECT_EQ(read(Output::kPosition), s.position);
    EXPECT_EQ(read(Output::kVelocity), s.velocity);

    const double p_l = s.pressure_a_Pa - one.actuator.area_b / one.actuator.area_a * s.pressure_b_Pa;
    const Eigen::Vector3d y{s.position, s.velocity, p_l};
    const Eigen::Vector3d z{s.position, s.velocity, of.load_cell};
    for (const Output output : {Output::kPosition, Output::kVelocity, Output::kLoadCellForce,
                                Output::kLoadCellForceWithInertia, Output::kHydraulicForce, Output::kTotalForce}) {
      const double wanted = full_output(output, one.actuator, one.load) * x;
      EXPECT_NEAR(load_pressure_output(output, one.actuator, one.load) * y, wanted, tolerance);
      EXPECT_NEAR(load_cell_output(output, one.actuator, one.load) * z, wanted, tolerance);
    }
  }
}

TEST(LinearForms, MeanBothValveSignsWhenAskedForNone) {
  Draw one = draw(4);
  const auto mean = [&](double sign) {
    one.point.valve_sign = sign;
    one.chambers.valve_sign = sign;
    return std::pair(linearise_load_pressure(one.actuator, one.load, one.point),
                     linearise_full(one.actuator, one.load, one.chambers));
  };
  const auto [pressure_out, full_out] = mean(1.0);
  const auto [pressure_in, full_in] = mean(-1.0);
  const auto [pressure, full] = mean(0.0);
  EXPECT_TRUE(pressure.a.isApprox(0.5 * (pressure_out.a + pressure_in.a), 1e-15));
  EXPECT_TRUE(pressure.b.isApprox(0.5 * (pressure_out.b + pressure_in.b), 1e-15));
  EXPECT_TRUE(full.a.isApprox(0.5 * (full_out.a + full_in.a), 1e-15));
  EXPECT_TRUE(full.b.isApprox(0.5 * (full_out.b + full_in.b), 1e-15));
  EXPECT_FALSE(full.b.isApprox(full_out.b, 1e-3));
}

TEST(SteadyChambers, AreInTheRatioOfSteadyFlowAndKeepTheLoadPressure) {
  for (int i = 0; i < kPoints; ++i) {
    const Draw one = draw(i);
    const double alpha = one.actuator.area_b / one.actuator.area_a;
    const State s = steady_chambers(one.actuator, one.point);
    const double p_s = one.actuator.supply_pressure_Pa;
    const double p_t = one.actuator.return_pressure_Pa;
    EXPECT_NEAR(s.pressure_a_Pa - alpha * s.pressure_b_Pa, one.point.load_pressure_Pa, 1e-14 * p_s);
    const bool extends = one.point.valve_sign > 0.0;
    const double left = extends ? p_s - s.pressure_a_Pa : s.pressure_a_Pa - p_t;  // (3.17), (3.18)
    const double right = (extends ? s.pressure_b_Pa - p_t : p_s - s.pressure_b_Pa) / (alpha * alpha);
    EXPECT_NEAR(left, right, 1e-14 * p_s / (alpha * alpha));
    EXPECT_GT(left, 0.0);
  }
}

TEST(NominalJoint, HasTheMatricesOfChapter3WithTheirErrata) {
  const ActuatorParams p = nominal_cylinder();
  const LoadParams load = nominal_load();
  ASSERT_TRUE(validate(p).ok());
  ASSERT_TRUE(validate(load).ok());
  const double alpha = p.area_b / p.area_a;
  const double V_a = p.line_volume_m3 + 0.5 * p.stroke * p.area_a;
  const double V_b = p.line_volume_m3 + 0.5 * p.stroke * p.area_b;
  const double root = std::sqrt(p.supply_pressure_Pa / (1.0 + alpha));
  // A root's change by the laminar range, (delta / drop)^2 / 4 < 1e-4 at drops above 5e6 Pa.
  constexpr double kLaminar = 1e-4;
  const StateSpace<4> out = linearise_full(p, load, nominal_chamber_point(1.0));
  Eigen::Matrix4d wanted = Eigen::Matrix4d::Zero();
  wanted(0, 1) = 1.0;
  wanted.row(1) << -load.stiffness, -1400.0, p.area_a, -p.area_b;
  wanted.row(1) /= 10.3141;
  wanted(2, 1) = -p.bulk_modulus_Pa * p.area_a / V_a;  // (3.8a), errata
  wanted(3, 1) = p.bulk_modulus_Pa * p.area_b / V_b;
  EXPECT_TRUE(out.a.isApprox(wanted, 1e-14));
  EXPECT_NEAR(out.b[2], p.bulk_modulus_Pa * p.valve_gain * root / V_a, kLaminar * out.b[2]);  // (3.8b)
  EXPECT_NEAR(out.b[3], -p.bulk_modulus_Pa * p.valve_gain * root / V_b, -kLaminar * out.b[3]);
  // Section 3.1.1 says (3.8) serves both signs of the valve. It does for alpha = 1 only: retracting, the drops are
  // p_a = p_s - p_b = alpha p_s / (1 + alpha), so both roots are sqrt(alpha) of those for extending.
  const StateSpace<4> in = linearise_full(p, load, nominal_chamber_point(-1.0));
  EXPECT_EQ(in.a, out.a);
  EXPECT_NEAR(in.b[2] / out.b[2], std::sqrt(alpha), kLaminar);
  EXPECT_NEAR(in.b[3] / out.b[3], std::sqrt(alpha), kLaminar);

  const StateSpace<3> simple = linearise_load_pressure(p, load, nominal_point(1.0));
  EXPECT_EQ(simple.a(2, 0), 0.0);  // (3.36a)
  EXPECT_EQ(simple.a(2, 2), 0.0);
  EXPECT_NEAR(simple.a(2, 1), -p.area_a * p.bulk_modulus_Pa * (1.0 / V_a + alpha * alpha / V_b),
              1e-14 * std::abs(simple.a(2, 1)));
}

}  // namespace linear_forms_test
}  // namespace farrier::plant
