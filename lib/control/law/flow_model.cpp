#include "control/law/flow_model.hpp"

#include <algorithm>
#include <cmath>

#include "plant/coulomb_friction.hpp"
#include "plant/oil.hpp"

namespace farrier::control {
namespace {

/// Coulomb friction turns over within this share of the full-open valve's speed.
constexpr double kFrictionTurn = 0.01;
/// Rate times substep, well inside the stability region of the fourth-order method (2.8).
constexpr double kRateTimesSubstep = 0.7;
constexpr int kMinSubsteps = 2;
constexpr int kMaxSubsteps = 10;

plant::State moved(const plant::State& s, const plant::State& rate, double h) noexcept {
  return {s.position + h * rate.position, s.velocity + h * rate.velocity, s.pressure_a_Pa + h * rate.pressure_a_Pa,
          s.pressure_b_Pa + h * rate.pressure_b_Pa};
}

}  // namespace

FlowModel::FlowModel(const plant::ActuatorParams& actuator, const plant::JointPhysics& physics, double slack_position,
                     double period_s) noexcept
    : actuator_(actuator),
      physics_(physics),
      slack_position_(slack_position),
      inverse_mass_(1.0 / (physics.load_mass + actuator.piston_mass)),
      friction_speed_(kFrictionTurn * plant::velocity_scale(actuator)),
      smallest_volume_m3_(plant::kSmallestVolumeShare * actuator.line_volume_m3) {
  const auto [v_a, v_b] = plant::chamber_volumes(actuator, 0.5 * actuator.stroke);
  const double stiffness =
      physics.bulk_modulus * (actuator.area_a * actuator.area_a / v_a + actuator.area_b * actuator.area_b / v_b) +
      physics.stiffness;
  const double damping = physics.damping + actuator.piston_damping + physics.coulomb / friction_speed_;
  const double rate = std::max(std::sqrt(stiffness * inverse_mass_), damping * inverse_mass_);
  substeps_ = static_cast<int>(std::clamp(std::ceil(rate * period_s / kRateTimesSubstep),
                                          static_cast<double>(kMinSubsteps), static_cast<double>(kMaxSubsteps)));
  substep_s_ = period_s / substeps_;
}

double FlowModel::load_and_piston_force(const plant::State& s, const Disturbance& d) const noexcept {
  const double v = s.velocity;
  const double friction = plant::coulomb_friction(physics_.coulomb, v, friction_speed_);
  const double spring = physics_.stiffness * (s.position - slack_position_);
  return -(physics_.damping + actuator_.piston_damping) * v - friction - spring + physics_.bias_force + d.load_force;
}

plant::State FlowModel::derivative(const plant::State& s, double flow_gain, double port_a, double port_b,
                                   const Disturbance& d) const noexcept {
  const auto [v_a, v_b] = plant::at_least(smallest_volume_m3_, plant::chamber_volumes(actuator_, s.position));
  const double leak = physics_.leakage * (s.pressure_a_Pa - s.pressure_b_Pa);
  // (2.14), (2.15)
  const double q_a = flow_gain * plant::orifice_root(port_a - s.pressure_a_Pa, actuator_.laminar_pressure_Pa) - leak;
  const double q_b = flow_gain * plant::orifice_root(port_b - s.pressure_b_Pa, actuator_.laminar_pressure_Pa) + leak;
  const double stiff_a = physics_.bulk_modulus / v_a;
  const double stiff_b = physics_.bulk_modulus / v_b;
  // F_h' = A_p (p_a' - alpha p_b') = d: a flow q into a and alpha q out of b.
  const double per_flow = actuator_.area_a * stiff_a + actuator_.area_b * stiff_b * actuator_.area_b / actuator_.area_a;
  const double q_d = d.force_rate_per_s / per_flow;
  const double hydraulic = plant::hydraulic_force(actuator_, s.pressure_a_Pa, s.pressure_b_Pa);
  return {
      s.velocity, (hydraulic + load_and_piston_force(s, d)) * inverse_mass_,
      plant::pressure_rate(stiff_a, q_a + q_d, actuator_.area_a * s.velocity),
      plant::pressure_rate(stiff_b, q_b - q_d * actuator_.area_b / actuator_.area_a, -actuator_.area_b * s.velocity)};
}

plant::State FlowModel::advance(const plant::State& start, double valve_current_A,
                                const Disturbance& d) const noexcept {
  const double gain = physics_.valve_gain * std::abs(valve_current_A);
  const auto [port_a, port_b] =
      plant::port_pressures(valve_current_A > 0.0, actuator_.supply_pressure_Pa, actuator_.return_pressure_Pa);
  const double h = substep_s_;
  plant::State s = start;
  for (int i = 0; i < substeps_; ++i) {
    const plant::State k1 = derivative(s, gain, port_a, port_b, d);
    const plant::State k2 = derivative(moved(s, k1, 0.5 * h), gain, port_a, port_b, d);
    const plant::State k3 = derivative(moved(s, k2, 0.5 * h), gain, port_a, port_b, d);
    const plant::State k4 = derivative(moved(s, k3, h), gain, port_a, port_b, d);
    s = moved(moved(moved(moved(s, k1, h / 6.0), k2, h / 3.0), k3, h / 3.0), k4, h / 6.0);
    s.pressure_a_Pa = std::max(s.pressure_a_Pa, 0.0);
    s.pressure_b_Pa = std::max(s.pressure_b_Pa, 0.0);
  }
  return s;
}

double FlowModel::load_cell_force(const plant::State& s, const Disturbance& d) const noexcept {
  const double hydraulic = plant::hydraulic_force(actuator_, s.pressure_a_Pa, s.pressure_b_Pa);
  const double acceleration = (hydraulic + load_and_piston_force(s, d)) * inverse_mass_;
  return hydraulic - actuator_.piston_damping * s.velocity - actuator_.piston_mass * acceleration;
}

void FlowModel::set_force(plant::State& s, double force, const Disturbance& d) const noexcept {
  // dF_s / dF_h = m_l / (m_l + m_p)
  const double change = (force - load_cell_force(s, d)) / (physics_.load_mass * inverse_mass_);
  const auto [v_a, v_b] = plant::at_least(smallest_volume_m3_, plant::chamber_volumes(actuator_, s.position));
  const double alpha = actuator_.area_b / actuator_.area_a;
  const double oil = change / (actuator_.area_a / v_a + actuator_.area_b * alpha / v_b);
  const double most = 2.0 * actuator_.supply_pressure_Pa;
  s.pressure_a_Pa = std::clamp(s.pressure_a_Pa + oil / v_a, 0.0, most);
  s.pressure_b_Pa = std::clamp(s.pressure_b_Pa - oil * alpha / v_b, 0.0, most);
}

}  // namespace farrier::control
