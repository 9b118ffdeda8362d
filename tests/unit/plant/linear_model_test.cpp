#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <tuple>

#include "plant/linear_model.hpp"
#include "test_joints.hpp"
#include "tests/support/dense_solvers.hpp"

namespace farrier::plant {
namespace linear_model_test {

/// Rates of (x, v, F_s) from the nonlinear equations. F_h = F_s + d_p v + m_p a is (2.22); pressures are by (3.19) and
/// (3.20), their rates and the acceleration by (2.10), (2.11), (2.28). F_s' = F_h' - d_p a - m_p a'.
Eigen::Vector3d nonlinear_rate(const ActuatorParams& act, const LoadParams& load, const Eigen::Vector3d& y, double u) {
  const double a = (y[2] - load.damping * y[1] - load.stiffness * (y[0] - load.equilibrium_position)) / load.mass;
  const double p_l = (y[2] + act.piston_damping * y[1] + act.piston_mass * a) / act.area_a;
  const State state = steady_chambers(act, {y[0], y[1], p_l, u, u});
  const JointEquations equations(act, load);
  const IntegrationState rate = equations.derivative(
      {state.position, state.velocity, state.pressure_a_Pa, state.pressure_b_Pa}, equations.hold(u, 0.0));
  const double hydraulic_rate = act.area_a * rate.compression_a_Pa - act.area_b * rate.compression_b_Pa;
  const double jerk = (hydraulic_rate - (load.damping + act.piston_damping) * rate.velocity - load.stiffness * y[1]) /
                      (load.mass + act.piston_mass);
  return {y[1], rate.velocity, hydraulic_rate - act.piston_damping * rate.velocity - act.piston_mass * jerk};
}

TEST(LinearModel, IsTheJacobianOfTheNonlinearEquations) {
  ActuatorParams act = test::rig_cylinder();
  act.laminar_pressure_Pa = 1.0;  // so that roots are the plain ones of the thesis to 1e-13
  act.return_pressure_Pa = 3e5;
  const NoiseStream draw(7, "jacobian", "points");
  for (Tick i = 0; i < 200; ++i) {
    const auto uniform = [&](int channel, double low, double high) {
      return low + (high - low) * draw.uniform(8 * i + channel);
    };
    const LoadParams load{uniform(0, 0.3, 60.0), uniform(1, 0.0, 1000.0), uniform(2, 0.0, 3e4), 0.04};
    OperatingPoint point;
    point.valve_sign = i % 2 == 0 ? 1.0 : -1.0;
    point.position = uniform(3, 0.01, 0.07);
    point.velocity = uniform(4, -0.3, 0.3);
    point.load_pressure_Pa = uniform(5, -30e5, 80e5);
    point.valve_current_A = point.valve_sign * uniform(6, 1e-3, 9e-3);
    const LinearModel model = linearise_load_cell_force(act, load, point);

    const Eigen::RowVector3d cell = load_pressure_output(Output::kLoadCellForceWithInertia, act, load);
    const Eigen::Vector3d from_middle{point.position - load.equilibrium_position, point.velocity,
                                      point.load_pressure_Pa};
    const Eigen::Vector4d at{point.position, point.velocity, cell * from_middle, point.valve_current_A};
    const auto rate = [&](const Eigen::Vector4d& y) { return nonlinear_rate(act, load, y.head<3>(), y[3]); };
    const Eigen::Vector4d step{1e-5, 1e-3, 10.0, 1e-5};
    for (int column = 0; column < 4; ++column) {
      const auto central = [&](double h) -> Eigen::Vector3d {
        const Eigen::Vector4d d = h * Eigen::Vector4d::Unit(column);
        return (rate(at + d) - rate(at - d)) / (2.0 * h);
      };
      // Richardson's extrapolation of central differences; its error is (step / scale)^4 < 1e-9.
      const Eigen::Vector3d slope = (4.0 * central(0.5 * step[column]) - central(step[column])) / 3.0;
      for (int row = 0; row < 3; ++row) {
        const double wanted = column < 3 ? model.a(row, column) : model.b[row];
        // Rounding is of the rates' terms: pressures' rates up to 1e11 Pa/s act on 2e-4 m^2.
        const double rounding = (row == 2 ? 1e-8 : 1e-11) / step[column];
        ASSERT_NEAR(slope[row], wanted, 1e-6 * std::abs(wanted) + rounding)
            << "point " << i << " row " << row << " column " << column;
      }
    }
  }
}

TEST(LinearModel, WithoutThePistonsMassHasTheDenominatorsOfTheThesis) {
  // (3.51a) with the row [-C/M, -d_l/M, 1/M]; the poles of a light load move, Section 10.2's "~200 Hz".
  const ActuatorParams act = test::rig_cylinder();
  const LoadParams load{0.5, 500.0, 21480.0, 0.04};
  const OperatingPoint point{.position = 0.04, .valve_sign = 1.0};
  const LinearModel thesis = linearise_load_cell_force(act, load, point, Volumes::kMoving, PistonMass::kNeglected);
  const double M = load.mass + act.piston_mass;
  EXPECT_TRUE(thesis.a.row(1).isApprox(Eigen::RowVector3d(-load.stiffness / M, -load.damping / M, 1.0 / M), 1e-15));
  EXPECT_NEAR(thesis.a(2, 0), act.piston_damping * load.stiffness / load.mass, 1e-6);
  EXPECT_NEAR(thesis.a(2, 2), -act.piston_damping / load.mass, 1e-9);
  const auto damped_Hz = [](const LinearModel& model) {
    return farrier::test::eigenvalues(model.a).imag().maxCoeff() / (2.0 * std::numbers::pi);
  };
  EXPECT_NEAR(damped_Hz(thesis), 208.6, 0.5);
  EXPECT_NEAR(damped_Hz(linearise_load_cell_force(act, load, point)), 235.5, 0.5);
}

TEST(LinearModel, MeansBothValveSignsWhenAskedForNone) {
  const LoadParams load{50.0, 500.0, 21480.0, 0.04};
  OperatingPoint point{0.04, 0.1, 5e5, 0.002, +1.0};
  const LinearModel out = linearise_load_cell_force(test::rig_cylinder(), load, point);
  point.valve_sign = -1.0;
  const LinearModel in = linearise_load_cell_force(test::rig_cylinder(), load, point);
  point.valve_sign = 0.0;
  const LinearModel mean = linearise_load_cell_force(test::rig_cylinder(), load, point);
  EXPECT_TRUE(mean.a.isApprox(0.5 * (out.a + in.a), 1e-15));
  EXPECT_TRUE(mean.b.isApprox(0.5 * (out.b + in.b), 1e-15));
  EXPECT_GT(out.b[2], in.b[2]);
}

TEST(LinearModel, PredictsTheNonlinearJointForSmallSteps) {
  const LoadParams load{2.5, 500.0, 21480.0, 0.04};
  ActuatorParams act = test::rig_cylinder();
  const double load_pressure_Pa = 0.0;
  const LinearModel model = linearise_load_cell_force(act, load, {0.04, 0.0, load_pressure_Pa, 0.0, 1.0});
  State steady = equilibrium(act, load, 0.04, 0.0);
  const double alpha3 = std::pow(act.area_b / act.area_a, 3);
  steady.pressure_a_Pa = alpha3 * act.supply_pressure_Pa / (1.0 + alpha3);  // (3.20), u > 0
  steady.pressure_b_Pa = steady.pressure_a_Pa * act.area_a / act.area_b;
  HydraulicJoint joint = HydraulicJoint::create(act, load, steady, 1e-9).value();
  const double current_A = 1e-5;
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();
  for (int tick = 0; tick < 10; ++tick) {
    joint.step(current_A, 0.0, test::kPeriod_s);
    for (int i = 0; i < 1000; ++i) {
      linear += 1e-6 * (model.a * linear + model.b * current_A);
    }
  }
  EXPECT_NEAR(joint.load_cell_force(), linear[2], 0.002 * std::abs(linear[2]));
  EXPECT_GT(linear[2], 0.1);
}

}  // namespace linear_model_test
}  // namespace farrier::plant
