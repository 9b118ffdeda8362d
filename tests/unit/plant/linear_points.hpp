#pragma once

#include <Eigen/Core>

#include <cmath>
#include <complex>

#include "plant/linear_model.hpp"
#include "plant/nominal.hpp"
#include "test_joints.hpp"

namespace farrier::plant::test {

inline constexpr int kPoints = 240;

/// Seeded operating points, both signs of the valve, over most of the state space.
struct Draw {
  ActuatorParams actuator;
  LoadParams load;
  OperatingPoint point;    ///< load pressure that both signs of the valve can hold
  ChamberPoint chambers;   ///< pressures free of each other
};

inline Draw draw(int i) {
  const NoiseStream noise(23, "linear forms", "points");
  const auto uniform = [&](int channel, double low, double high) {
    return low + (high - low) * noise.uniform(16 * i + channel);
  };
  Draw one;
  one.actuator = i % 3 == 0 ? nominal_cylinder() : i % 3 == 1 ? hyq_cylinder() : rig_cylinder();
  one.actuator.return_pressure_Pa = uniform(0, 0.0, 5e5);
  one.load = {uniform(1, 1.0, 127.0), uniform(2, 0.0, 2000.0), uniform(3, 0.0, 3.5e4), 0.04};
  const double p_s = one.actuator.supply_pressure_Pa;
  const double sign = i % 2 == 0 ? 1.0 : -1.0;
  one.point = {0.08 * uniform(4, 0.05, 0.95), uniform(5, -1.0, 1.0), p_s * uniform(6, -0.5, 0.5),
               sign * uniform(7, 0.0, 0.01), sign};
  one.chambers = {{one.point.position, one.point.velocity, p_s * uniform(8, 0.1, 0.9), p_s * uniform(9, 0.1, 0.9)},
                  one.point.valve_current_A, sign};
  return one;
}

/// Right-hand side of Hubacher (2014) (2.30a) for sign +1 and (2.30b) for sign -1, as printed, in any number type;
/// |u| = sign u.
template <class Scalar>
Eigen::Matrix<Scalar, 4, 1> full_rate(const ActuatorParams& p, const LoadParams& load, double sign,
                                      const Eigen::Matrix<Scalar, 4, 1>& x, const Scalar& u) {
  using std::sqrt;
  const double alpha = p.area_b / p.area_a;
  const Scalar opening = p.valve_gain * sign * u;
  const Scalar V_a = p.line_volume_m3 + x[0] * p.area_a;
  const Scalar V_b = p.line_volume_m3 + (p.stroke - x[0]) * alpha * p.area_a;
  const double M = load.mass + p.piston_mass;
  const double B = load.damping + p.piston_damping;
  const Scalar a = (-B * x[1] - load.stiffness * (x[0] - load.equilibrium_position)) / M +
                   p.area_a / M * (x[2] - alpha * x[3]);
  if (sign > 0.0) {
    return {x[1], a, p.bulk_modulus_Pa / V_a * (opening * sqrt(p.supply_pressure_Pa - x[2]) - p.area_a * x[1]),
            p.bulk_modulus_Pa / V_b * (-opening * sqrt(x[3] - p.return_pressure_Pa) + alpha * p.area_a * x[1])};
  }
  return {x[1], a, p.bulk_modulus_Pa / V_a * (-opening * sqrt(x[2] - p.return_pressure_Pa) - p.area_a * x[1]),
          p.bulk_modulus_Pa / V_b * (opening * sqrt(p.supply_pressure_Pa - x[3]) + alpha * p.area_a * x[1])};
}

/// (2.28) and the load pressure's rate (3.21a), (3.21b), as printed.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> load_pressure_rate(const ActuatorParams& p, const LoadParams& load, double sign,
                                               const Eigen::Matrix<Scalar, 3, 1>& x, const Scalar& u) {
  using std::sqrt;
  const double alpha = p.area_b / p.area_a;
  const double alpha2 = alpha * alpha;
  const double alpha3 = alpha2 * alpha;
  const double p_s = p.supply_pressure_Pa;
  const double p_t = p.return_pressure_Pa;
  const Scalar opening = p.valve_gain * sign * u / std::sqrt(1.0 + alpha3);
  const Scalar by_a = p.bulk_modulus_Pa / (p.line_volume_m3 + x[0] * p.area_a);
  const Scalar by_b = alpha * p.bulk_modulus_Pa / (p.line_volume_m3 + (p.stroke - x[0]) * alpha * p.area_a);
  const double M = load.mass + p.piston_mass;
  const double B = load.damping + p.piston_damping;
  const Scalar a = (-B * x[1] - load.stiffness * (x[0] - load.equilibrium_position) + p.area_a * x[2]) / M;
  const Scalar swept = p.area_a * x[1];
  if (sign > 0.0) {
    return {x[1], a, by_a * (opening * sqrt(p_s - x[2] - alpha * p_t) - swept) -
                         by_b * (-opening * sqrt(alpha2 * p_s - alpha2 * x[2] - alpha3 * p_t) + alpha * swept)};
  }
  return {x[1], a, by_a * (-opening * sqrt(alpha * p_s + x[2] - p_t) - swept) -
                       by_b * (opening * sqrt(alpha3 * p_s + alpha2 * x[2] - alpha2 * p_t) + alpha * swept)};
}

/// Derivative of every row with respect to each state and the input, by complex steps (Squire and Trapp 1998): exact
/// but for rounding.
template <int N, class Rate>
StateSpace<N> complex_step(const Rate& rate, const Eigen::Matrix<double, N, 1>& x, double u) {
  using Complex = std::complex<double>;
  constexpr double kStep = 1e-30;
  StateSpace<N> model;
  for (int column = 0; column <= N; ++column) {
    Eigen::Matrix<Complex, N, 1> at = x.template cast<Complex>();
    Complex input = u;
    (column < N ? at[column] : input) += Complex(0.0, kStep);
    const Eigen::Matrix<double, N, 1> slope = rate(at, input).imag() / kStep;
    if (column < N) {
      model.a.col(column) = slope;
    } else {
      model.b = slope;
    }
  }
  return model;
}

}  // namespace farrier::plant::test
