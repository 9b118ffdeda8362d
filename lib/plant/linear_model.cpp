#include "plant/linear_model.hpp"

#include <cmath>

#include "plant/oil.hpp"

namespace farrier::plant {
namespace {

/// The model for the point's sign of the valve, or the mean of both.
template <class Model, class Point, class ForSign>
Model for_sign_or_mean(Point point, ForSign for_sign) {
  if (point.valve_sign != 0.0) {
    return for_sign(point);
  }
  point.valve_sign = 1.0;
  const Model extending = for_sign(point);
  point.valve_sign = -1.0;
  const Model retracting = for_sign(point);
  return {0.5 * (extending.a + retracting.a), 0.5 * (extending.b + retracting.b)};
}

/// (3.47): m_l a = F_s - d_l v - C x, with `mass` for m_l.
Eigen::RowVector3d acceleration_row(const LoadParams& load, double mass) {
  return Eigen::RowVector3d(-load.stiffness, -load.damping, 1.0) / mass;
}

LinearModel load_cell_model(const ActuatorParams& actuator, const LoadParams& load, const LoadPressureCoefficients& of,
                            PistonMass piston) {
  const double A_p = actuator.area_a;
  const double G_Fs = of.by_pressure();         // (3.43)
  const double G_xp = A_p * of.by_position();   // (3.44)
  const double G_uv = A_p * of.K_uv * of.root;  // (3.45)
  const double d_p = actuator.piston_damping;
  const double m_p = piston == PistonMass::kCounted ? actuator.piston_mass : 0.0;
  const double ratio = m_p / load.mass;
  const Eigen::RowVector3d a = acceleration_row(load, load.mass);
  const Eigen::RowVector3d hydraulic = Eigen::RowVector3d(0.0, d_p, 1.0) + m_p * a;  // F_h, (2.22)
  const Eigen::RowVector3d hydraulic_rate = G_Fs * hydraulic + Eigen::RowVector3d(G_xp, A_p * of.K_vp, 0.0);

  LinearModel model;
  model.a.row(0) << 0.0, 1.0, 0.0;
  model.a.row(1) = piston == PistonMass::kCounted ? a : acceleration_row(load, load.mass + actuator.piston_mass);
  // (3.40) with m_l a' = F_s' - d_l a - C v, which has F_s' on both sides; (3.48) for m_p = 0.
  const Eigen::RowVector3d load_rate = load.damping * a + Eigen::RowVector3d(0.0, load.stiffness, 0.0);
  model.a.row(2) = (hydraulic_rate - d_p * a + ratio * load_rate) / (1.0 + ratio);
  model.b << 0.0, 0.0, G_uv / (1.0 + ratio);
  return model;
}

StateSpace<3> load_pressure_model(const ActuatorParams& actuator, const LoadParams& load,
                                  const LoadPressureCoefficients& of) {
  const double M = load.mass + actuator.piston_mass;        // (2.25)
  const double B = load.damping + actuator.piston_damping;  // (2.26)
  StateSpace<3> model;
  // (A.23), (A.25)
  model.a << 0.0, 1.0, 0.0,                                  //
      -load.stiffness / M, -B / M, actuator.area_a / M,      // (2.28)
      of.by_position(), of.by_velocity(), of.by_pressure();  // (3.22)
  model.b << 0.0, 0.0, of.by_current();                      // (A.24), (A.26)
  return model;
}

StateSpace<4> full_model(const ActuatorParams& actuator, const LoadParams& load, const ChamberPoint& point,
                         Volumes volumes) {
  const bool extends = point.valve_sign > 0.0;
  const double A_a = actuator.area_a;
  const double A_b = actuator.area_b;
  const double beta_e = actuator.bulk_modulus_Pa;
  const double x = point.state.position;
  const double v = point.state.velocity;
  const auto [V_a, V_b] = chamber_volumes(actuator, x);
  const double M = load.mass + actuator.piston_mass;        // (2.25)
  const double B = load.damping + actuator.piston_damping;  // (2.26)

  // Flows into the chambers; the ports carry the sign of u, so that both signs are one form.
  const auto [port_a, port_b] = port_pressures(extends, actuator.supply_pressure_Pa, actuator.return_pressure_Pa);
  const double gain = actuator.valve_gain * std::abs(point.valve_current_A);
  const auto into_a = port_flow(1.0, port_a - point.state.pressure_a_Pa, actuator.laminar_pressure_Pa);  // per gain
  const auto into_b = port_flow(1.0, port_b - point.state.pressure_b_Pa, actuator.laminar_pressure_Pa);
  const double sign = extends ? 1.0 : -1.0;

  StateSpace<4> model;
  model.a(0, 1) = 1.0;
  model.a.row(1) << -load.stiffness / M, -B / M, A_a / M, -A_b / M;
  if (volumes == Volumes::kMoving) {
    model.a(2, 0) = -beta_e * A_a / (V_a * V_a) * (gain * into_a.flow - A_a * v);  // (A.5), (A.13)
    model.a(3, 0) = beta_e * A_b / (V_b * V_b) * (gain * into_b.flow + A_b * v);   // (A.8), (A.16)
  }
  model.a(2, 1) = -beta_e * A_a / V_a;                  // (A.6), (A.14)
  model.a(3, 1) = beta_e * A_b / V_b;                   // (A.9), (A.17)
  model.a(2, 2) = -beta_e / V_a * gain * into_a.slope;  // (A.7), (A.15)
  model.a(3, 3) = -beta_e / V_b * gain * into_b.slope;  // (A.10), (A.18)
  // (A.11), (A.19): d|u| = sign du
  model.b << 0.0, 0.0, sign * beta_e / V_a * actuator.valve_gain * into_a.flow,
      sign * beta_e / V_b * actuator.valve_gain * into_b.flow;
  return model;
}

/// Rows of a model in pressures; `hydraulic` reads F_h.
template <class Row>
Row pressure_output(Output output, const Row& hydraulic, const ActuatorParams& actuator, const LoadParams& load) {
  const double M = load.mass + actuator.piston_mass;
  const double B = load.damping + actuator.piston_damping;
  const Row position = Row::Unit(0);
  const Row velocity = Row::Unit(1);
  const Row total = hydraulic - B * velocity - load.stiffness * position;  // M a, (2.28)
  const Row cell = hydraulic - actuator.piston_damping * velocity;         // (3.3)
  switch (output) {
    case Output::kPosition:
      return position;
    case Output::kVelocity:
      return velocity;
    case Output::kLoadCellForce:
      return cell;
    case Output::kLoadCellForceWithInertia:
      return cell - actuator.piston_mass / M * total;  // (2.22)
    case Output::kHydraulicForce:
      return hydraulic;
    case Output::kTotalForce:
      return total;
  }
  return Row::Zero();
}

}  // namespace

LinearModel linearise_load_cell_force(const ActuatorParams& actuator, const LoadParams& load,
                                      const OperatingPoint& point, Volumes volumes, PistonMass piston) {
  return for_sign_or_mean<LinearModel>(point, [&](const OperatingPoint& at) {
    return load_cell_model(actuator, load, load_pressure_coefficients(actuator, at, volumes), piston);
  });
}

Eigen::RowVector3d load_cell_output(Output output, const ActuatorParams& actuator, const LoadParams& load,
                                    PistonMass piston) {
  const double m_p = piston == PistonMass::kCounted ? actuator.piston_mass : 0.0;
  const Eigen::RowVector3d a = acceleration_row(load, load.mass);
  const Eigen::RowVector3d cell(0.0, 0.0, 1.0);
  switch (output) {
    case Output::kPosition:
      return {1.0, 0.0, 0.0};
    case Output::kVelocity:
      return {0.0, 1.0, 0.0};
    case Output::kLoadCellForce:
      return cell + m_p * a;
    case Output::kLoadCellForceWithInertia:
      return cell;
    case Output::kHydraulicForce:
      return cell + Eigen::RowVector3d(0.0, actuator.piston_damping, 0.0) + m_p * a;  // (2.22)
    case Output::kTotalForce:
      return (load.mass + m_p) * a;
  }
  return Eigen::RowVector3d::Zero();
}

StateSpace<3> linearise_load_pressure(const ActuatorParams& actuator, const LoadParams& load,
                                      const OperatingPoint& point, Volumes volumes) {
  return for_sign_or_mean<StateSpace<3>>(point, [&](const OperatingPoint& at) {
    return load_pressure_model(actuator, load, load_pressure_coefficients(actuator, at, volumes));
  });
}

Eigen::RowVector3d load_pressure_output(Output output, const ActuatorParams& actuator, const LoadParams& load) {
  return pressure_output<Eigen::RowVector3d>(output, {0.0, 0.0, actuator.area_a}, actuator, load);
}

StateSpace<4> linearise_full(const ActuatorParams& actuator, const LoadParams& load, const ChamberPoint& point,
                             Volumes volumes) {
  return for_sign_or_mean<StateSpace<4>>(
      point, [&](const ChamberPoint& at) { return full_model(actuator, load, at, volumes); });
}

Eigen::RowVector4d full_output(Output output, const ActuatorParams& actuator, const LoadParams& load) {
  return pressure_output<Eigen::RowVector4d>(output, {0.0, 0.0, actuator.area_a, -actuator.area_b}, actuator, load);
}

}  // namespace farrier::plant
