#include "estimation/grey_box_model.hpp"

#include <algorithm>
#include <cmath>

#include "core/portable_math.hpp"
#include "plant/coulomb_friction.hpp"
#include "plant/end_stop.hpp"
#include "plant/oil.hpp"

namespace farrier::estimation {
namespace {

using plant::JointPhysics;

// Substeps per radian of the oil's and the load's oscillation, and per time constant of a filling chamber. Measured
// against the plant at 1 kHz (docs/derivations/grey-box.md).
constexpr double kPhasePerSubstep = 0.7;
constexpr double kDecayPerSubstep = 1.0;
constexpr int kFewestSubsteps = 4;
// No damping is below this share of the piston's: its logarithm would not be finite.
constexpr double kLeastDamping = 1e-6;
constexpr double kLeastMass = 1e-9;

/// S' = J S + J_theta, J's zeros left out. Plain loops: they become vector code, and compile in no time.
void rate_of(const Sensitivity& sensitivity, const GreyBoxModel::Rate& r, Sensitivity& rate) noexcept {
  constexpr int n = kGreyBoxStates;
  const double* s = sensitivity.data();  // column after column
  double* d = rate.data();
  for (int i = 0; i < n; ++i) {
    const double x = s[i], v = s[n + i], a = s[2 * n + i], b = s[3 * n + i];
    d[i] = v;
    d[n + i] = r.velocity_by[0] * x + r.velocity_by[1] * v + r.velocity_by[2] * a + r.velocity_by[3] * b;
    d[2 * n + i] = r.a_by[0] * x + r.a_by[1] * v + r.a_by[2] * a + r.a_by[3] * b;
    d[3 * n + i] = r.b_by[0] * x + r.b_by[1] * v + r.b_by[2] * a + r.b_by[3] * b;
  }
  for (int i = 0; i < 5; ++i) {
    d[n + kMotions + i] += r.load_by[i];
  }
  for (int i = 0; i < 3; ++i) {
    d[2 * n + kMotions + 5 + i] += r.a_by_oil[i];
    d[3 * n + kMotions + 5 + i] += r.b_by_oil[i];
  }
}

/// to = from + h rate, for both the motion and its sensitivity.
void advance(const Motion& motion, const Sensitivity& by, double h, const Motion& rate, const Sensitivity& by_rate,
             Motion& to, Sensitivity& by_to) noexcept {
  for (int i = 0; i < kMotions; ++i) {
    to.data()[i] = motion.data()[i] + h * rate.data()[i];
  }
  for (int i = 0; i < kMotions * kGreyBoxStates; ++i) {
    by_to.data()[i] = by.data()[i] + h * by_rate.data()[i];
  }
}

/// Sum of the four stages of the classical Runge-Kutta step, kept in k1 and s1.
void add_stages(Motion& k1, const Motion& k2, const Motion& k3, const Motion& k4, Sensitivity& s1,
                const Sensitivity& s2, const Sensitivity& s3, const Sensitivity& s4) noexcept {
  for (int i = 0; i < kMotions; ++i) {
    k1.data()[i] += 2.0 * (k2.data()[i] + k3.data()[i]) + k4.data()[i];
  }
  for (int i = 0; i < kMotions * kGreyBoxStates; ++i) {
    s1.data()[i] += 2.0 * (s2.data()[i] + s3.data()[i]) + s4.data()[i];
  }
}

}  // namespace

Unknowns GreyBoxModel::unknowns_of(const JointPhysics& p) const noexcept {
  Unknowns u;
  u << portable::log(std::max(p.load_mass, kLeastMass)),
      portable::log(std::max(p.damping, kLeastDamping * std::max(actuator_.piston_damping, 1.0))), p.coulomb,
      p.stiffness, p.bias_force, portable::log(p.valve_gain / actuator_.valve_gain),
      portable::log(p.bulk_modulus / actuator_.bulk_modulus_Pa), p.leakage;
  return u;
}

JointPhysics GreyBoxModel::physics_of(const Unknowns& u) const noexcept {
  return {.load_mass = portable::exp(u(kMass)),
          .damping = portable::exp(u(kDamping)),
          .coulomb = u(kCoulomb),
          .stiffness = u(kStiffness),
          .bias_force = u(kBias),
          .valve_gain = actuator_.valve_gain * portable::exp(u(kValveGain)),
          .bulk_modulus = actuator_.bulk_modulus_Pa * portable::exp(u(kBulkModulus)),
          .leakage = u(kLeakage)};
}

// (2.24) with Coulomb friction and a bias force:
//   (m_l + m_p) a = F_h - (d_l + d_p) v - C (x - x_eq) - (F_c + F_p) v / sqrt(v^2 + v_c^2) + F_bias + F_stop
void GreyBoxModel::add_load(Rate& r, const Motion& at, const JointPhysics& p) const noexcept {
  const plant::ActuatorParams& act = actuator_;
  const double x = at(0), v = at(1);
  const double full_a = at(2) > 0.0 ? 1.0 : 0.0;
  const double full_b = at(3) > 0.0 ? 1.0 : 0.0;
  r.stop_force = r.stop_by_position = r.stop_by_velocity = 0.0;
  if (x < 0.0 || x > act.stroke) {
    const double side = x < 0.0 ? 1.0 : -1.0;  // direction of the push
    const plant::StopPush push = plant::stop_push_and_slopes(x < 0.0 ? -x : x - act.stroke, -side * v,
                                                             1000.0 / act.stroke, act.stop_stiffness, act.stop_damping);
    r.stop_force = side * push.force;
    r.stop_by_position = -push.by_depth;
    r.stop_by_velocity = -push.by_speed;
  }
  const auto [slip, slip_slope] = plant::smooth_sign(v, slip_velocity_);
  r.seal_force = seal_friction_ * slip;
  r.seal_by_velocity = seal_friction_ * slip_slope;
  const double stretch = x - equilibrium_position_;
  const double w = 1.0 / (p.load_mass + act.piston_mass);
  const double a =
      w * (act.area_a * full_a * at(2) - act.area_b * full_b * at(3) - (p.damping + act.piston_damping) * v -
           p.stiffness * stretch - (p.coulomb + seal_friction_) * slip + p.bias_force + r.stop_force);
  r.value(0) = v;
  r.value(1) = a;
  r.velocity_by << w * (r.stop_by_position - p.stiffness),
      w * (r.stop_by_velocity - p.damping - act.piston_damping - (p.coulomb + seal_friction_) * slip_slope),
      w * act.area_a * full_a, -w * act.area_b * full_b;
  r.load_by << -a * p.load_mass * w, -w * p.damping * v, -w * slip, -w * stretch, w;
}

// (2.10), (2.11) as plant::JointEquations has them, less q_l = k_l (p_a - p_b) from a to b:
//   c_a' = beta_e / V_a (q_a - A_p v (1 + void_a / beta_e) - q_l),  c_b' = beta_e / V_b (q_b + alpha A_p v (...) + q_l)
void GreyBoxModel::add_oil(Rate& r, const Motion& at, const JointPhysics& p, double current_A) const noexcept {
  const plant::ActuatorParams& act = actuator_;
  const double x = at(0), v = at(1);
  const double beta = p.bulk_modulus;
  const double inverse_beta = 1.0 / beta;
  const auto ports = plant::port_pressures(current_A > 0.0, act.supply_pressure_Pa, act.return_pressure_Pa);
  const auto volumes = plant::chamber_volumes(act, x);
  const double gain = p.valve_gain * std::abs(current_A);
  const double p_a = std::max(at(2), 0.0), p_b = std::max(at(3), 0.0);
  const double smallest = plant::kSmallestVolumeShare * act.line_volume_m3;
  const double leak = p.leakage * (p_a - p_b);

  const auto chamber = [&](double compression, double pressure, double port, double volume, double area, double leaving,
                           double& value, double& by_x, double& by_v, double& by_own, double& by_other,
                           Eigen::Vector3d& by_oil, double leak_sign) noexcept {
    const auto [flow, flow_slope] = plant::port_flow(gain, port - pressure, act.laminar_pressure_Pa);
    const double filled = plant::filled_share(compression, pressure, inverse_beta);
    const bool shrunk = volume < smallest;
    const double stiffness = beta / (shrunk ? smallest : volume);
    value = plant::pressure_rate(stiffness, flow - leaving, area * v * filled);
    by_x = shrunk ? 0.0 : -value * area / volume;
    by_v = -stiffness * area * filled;
    by_own = compression > 0.0 ? -stiffness * (flow_slope + p.leakage) : -stiffness * area * v * inverse_beta;
    by_other = stiffness * p.leakage;
    by_oil << stiffness * flow, stiffness * (flow - area * v - leaving), -leak_sign * stiffness * (p_a - p_b);
  };
  chamber(at(2), p_a, ports.a_Pa, volumes.a_m3, act.area_a, leak, r.value(2), r.a_by(0), r.a_by(1), r.a_by(2),
          r.a_by(3), r.a_by_oil, 1.0);
  chamber(at(3), p_b, ports.b_Pa, volumes.b_m3, -act.area_b, -leak, r.value(3), r.b_by(0), r.b_by(1), r.b_by(3),
          r.b_by(2), r.b_by_oil, -1.0);
  r.a_by(3) *= at(3) > 0.0 ? 1.0 : 0.0;
  r.b_by(2) *= at(2) > 0.0 ? 1.0 : 0.0;
}

GreyBoxModel::Rate GreyBoxModel::rate(const Motion& at, const JointPhysics& physics, double current_A) const noexcept {
  Rate r;
  add_load(r, at, physics);
  add_oil(r, at, physics, current_A);
  return r;
}

GreyBoxModel::Passage GreyBoxModel::pass(const Motion& from, const Unknowns& unknowns, double current_A,
                                         double period_s) const noexcept {
  const JointPhysics physics = physics_of(unknowns);
  const double current = std::clamp(current_A, -actuator_.valve_current_max_A, actuator_.valve_current_max_A);
  Passage out{from, Sensitivity::Zero(), 1.0 / (physics.load_mass + actuator_.piston_mass), false};
  out.by.topRows<kMotions>().setIdentity();
  double left = period_s;
  for (int n = 0; n < kMostSubsteps && left > 0.0; ++n) {
    const Rate k1 = rate(out.motion, physics, current);
    out.bent = out.bent || out.motion(0) < 0.0 || out.motion(0) > actuator_.stroke || out.motion(2) < 0.0 ||
               out.motion(3) < 0.0;
    // Oscillation: oil spring on the mass. Decay: friction on the mass, a chamber filling through its orifice.
    const double oscillation =
        std::sqrt(std::abs(k1.velocity_by(2) * k1.a_by(1)) + std::abs(k1.velocity_by(3) * k1.b_by(1)));
    const double decay = std::max({-k1.velocity_by(1), -k1.a_by(2), -k1.b_by(3)});
    const double shortest = std::max(oscillation / kPhasePerSubstep, decay / kDecayPerSubstep);
    const double wanted = std::ceil(left * std::max(shortest, kFewestSubsteps / period_s) - 1e-9);
    const double h = std::max(left / std::max(wanted, 1.0), left / (kMostSubsteps - n));
    left = h < left * (1.0 - 1e-9) ? left - h : 0.0;

    Motion at;
    Sensitivity by, s1, s2, s3, s4;
    rate_of(out.by, k1, s1);
    advance(out.motion, out.by, 0.5 * h, k1.value, s1, at, by);
    const Rate k2 = rate(at, physics, current);
    rate_of(by, k2, s2);
    advance(out.motion, out.by, 0.5 * h, k2.value, s2, at, by);
    const Rate k3 = rate(at, physics, current);
    rate_of(by, k3, s3);
    advance(out.motion, out.by, h, k3.value, s3, at, by);
    const Rate k4 = rate(at, physics, current);
    rate_of(by, k4, s4);
    Motion sum = k1.value;
    add_stages(sum, k2.value, k3.value, k4.value, s1, s2, s3, s4);
    advance(out.motion, out.by, h / 6.0, sum, s1, out.motion, out.by);
  }
  return out;
}

GreyBoxModel::Force GreyBoxModel::load_cell_force(const Motion& at, const Unknowns& unknowns) const noexcept {
  const plant::ActuatorParams& act = actuator_;
  Rate r;
  add_load(r, at, physics_of(unknowns));
  const double p_a = std::max(at(2), 0.0), p_b = std::max(at(3), 0.0);
  Force force;
  force.value = plant::hydraulic_force(act, p_a, p_b) + r.stop_force - act.piston_damping * at(1) - r.seal_force -
                act.piston_mass * r.value(1);
  force.by.setZero();
  force.by.head<kMotions>() << r.stop_by_position, r.stop_by_velocity - act.piston_damping - r.seal_by_velocity,
      at(2) > 0.0 ? act.area_a : 0.0, at(3) > 0.0 ? -act.area_b : 0.0;
  force.by.head<kMotions>() -= act.piston_mass * r.velocity_by;
  force.by.segment<5>(kMotions) = -act.piston_mass * r.load_by;
  return force;
}

Motion GreyBoxModel::at_rest(const Eigen::Vector3d& measured) const noexcept {
  // The pressures that hold F_s + d_p v at rest also hold an equal push on a load without spring.
  const plant::State rest =
      plant::equilibrium(actuator_, {}, measured(0), -(measured(2) + actuator_.piston_damping * measured(1)));
  const double most = 2.0 * actuator_.supply_pressure_Pa;
  return {measured(0), measured(1), std::clamp(rest.pressure_a_Pa, 0.0, most),
          std::clamp(rest.pressure_b_Pa, 0.0, most)};
}

}  // namespace farrier::estimation
