#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <tuple>

#include "plant/linear_model.hpp"
#include "test_joints.hpp"

namespace farrier::plant {
namespace linear_model_test {

/// Right-hand side in (x, v, F_s) from the nonlinear equations: F_h = F_s + d_p v (m_p neglected), pressures by
/// (3.19), (3.20), their rates by (2.10), (2.11), F_s' = A_p p_l' - d_p a (3.40).
Eigen::Vector3d nonlinear_rate(const ActuatorParams& act, const LoadParams& load, const Eigen::Vector3d& y, double u) {
  const double alpha = act.area_b / act.area_a;
  const double p_l = (y[2] + act.piston_damping * y[1]) / act.area_a;
  const double toward_a = u > 0.0 ? act.supply_pressure_Pa : act.return_pressure_Pa;
  const double toward_b = u > 0.0 ? act.return_pressure_Pa : act.supply_pressure_Pa;
  const double p_b = (alpha * alpha * (toward_a - p_l) + toward_b) / (1.0 + std::pow(alpha, 3));
  const JointEquations equations(act, load);
  const IntegrationState rate =
      equations.derivative({y[0], y[1], p_l + alpha * p_b, p_b}, equations.hold(u, 0.0));
  const double a = (y[2] - load.damping * y[1] - load.stiffness * (y[0] - load.equilibrium_position)) / load.mass;
  return {y[1], a, act.area_a * rate.compression_a_Pa - act.area_b * rate.compression_b_Pa - act.piston_damping * a};
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
    const LoadParams load{uniform(0, 1.0, 60.0), uniform(1, 0.0, 1000.0), uniform(2, 0.0, 3e4), 0.04};
    OperatingPoint point;
    point.valve_sign = i % 2 == 0 ? 1.0 : -1.0;
    point.position = uniform(3, 0.01, 0.07);
    point.velocity = uniform(4, -0.3, 0.3);
    point.load_pressure_Pa = uniform(5, -30e5, 80e5);
    point.valve_current_A = point.valve_sign * uniform(6, 1e-3, 9e-3);
    const LinearModel model = linearise_load_cell_force(act, load, point);

    const Eigen::Vector3d y{point.position, point.velocity,
                            act.area_a * point.load_pressure_Pa - act.piston_damping * point.velocity};
    const Eigen::Vector3d step{1e-5, 1e-3, 1.0};
    for (int column = 0; column < 3; ++column) {
      const Eigen::Vector3d d = step[column] * Eigen::Vector3d::Unit(column);
      const Eigen::Vector3d slope = (nonlinear_rate(act, load, y + d, point.valve_current_A) -
                                     nonlinear_rate(act, load, y - d, point.valve_current_A)) / (2.0 * step[column]);
      for (int row = 0; row < 3; ++row) {
        // Central differences: third-order terms (step / scale)^2 < 1e-5, plus rounding of the rates.
        const double tolerance = 1e-5 * std::abs(model.a(row, column)) + 1e-6 * model.a.row(row).cwiseAbs().maxCoeff() *
                                                                              (column == 2 ? 1e-3 : 1.0);
        ASSERT_NEAR(slope[row], model.a(row, column), tolerance) << "point " << i << " row " << row;
      }
    }
    const double du = 1e-5;
    const Eigen::Vector3d gain = (nonlinear_rate(act, load, y, point.valve_current_A + du) -
                                  nonlinear_rate(act, load, y, point.valve_current_A - du)) / (2.0 * du);
    ASSERT_NEAR(gain[2] * point.valve_sign, model.b[2] * point.valve_sign, 1e-6 * model.b[2]);
    ASSERT_EQ(model.b[0], 0.0);
    ASSERT_EQ(model.b[1], 0.0);
  }
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
  // At null with light piston the thesis model differs from the plant by m_p / m_l in the force rate.
  const LoadParams load{50.0, 500.0, 21480.0, 0.04};
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
  EXPECT_NEAR(joint.load_cell_force(), linear[2], 0.03 * std::abs(linear[2]));
  EXPECT_GT(linear[2], 1.0);
}

}  // namespace linear_model_test
}  // namespace farrier::plant
