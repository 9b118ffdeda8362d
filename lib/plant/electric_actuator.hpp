#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/result.hpp"
#include "plant/actuator.hpp"
#include "plant/coulomb_friction.hpp"
#include "plant/end_stop.hpp"
#include "plant/state_space.hpp"

namespace farrier::plant {

// An electric joint: brushless motor, gear, and a spring between gear and load in which the torque sensor sits. The
// model is that of Spong (1987), (4) and (5), a rotor and a load joined by a spring, with the winding in front. The
// spring makes a geared motor a torque source: Pratt and Williamson (1995).
//
//   L i'      = R (u - i) - K N w                       winding, driven by a voltage V = R u.
//   J N^2 w'  = N K i - d_r w - T_c phi(w) - T          rotor and gear, seen at the gear's output.
//   T         = k delta + b (w - v),   delta' = w - v   spring: the torque sensor reads T.
//   m_l v'    = T - d_l v - C (x - x_eq) + T_ext + T_stop.
//
// The command u is the current that the drive's voltage would drive through a winding at rest, so that the joint's
// current limit is V_max / R. The drive has no current loop: the back-EMF K N w makes the rotor follow its command in
// speed, as the valve's flow does with a piston. So (x, v, T) describe the joint as (x, v, F_s) describe a hydraulic
// one (docs/decisions/0045-electric-joint.md).
//
// A rigid drive has no spring: rotor and load are one inertia, and the drive controls its current, from which it knows
// the torque. Direct drives of small robots are built so (Wensing et al. 2017). The current has a time constant tau.
//   T = N K i,   tau i' = u* - i.
//   (m_l + J N^2) v' = T - (d_l + d_r) v - T_c phi(v) - C (x - x_eq) + T_ext + T_stop.
//
// The command u* is within the current that the voltage can drive at this speed. R u* + N K v is within +-V_max.

/// Values at the rotor where the name says rotor, else seen at the gear's output. All finite; docs/notation.md.
struct ElectricParams {
  double torque_constant_Nm_A = 0.0;    ///< K of the rotor, also V s/rad; > 0
  double winding_resistance_Ohm = 0.0;  ///< R, > 0
  double winding_inductance_H = 0.0;    ///< L, > 0; unused by a rigid drive
  double supply_voltage_V = 0.0;        ///< V_max: commands are limited to V_max / R; > 0
  double rotor_inertia_kg_m2 = 0.0;     ///< J, > 0; of a rigid drive >= 0
  double gear_ratio = 0.0;              ///< N, rotor turns per turn of the output; > 0
  double damping = 0.0;                 ///< d_r of rotor and gear, Nms/rad; >= 0
  double coulomb = 0.0;                 ///< T_c of rotor and gear, Nm; >= 0
  double slip_velocity = 0.0;           ///< w_s at which that has 0.7 of its size, rad/s; > 0
  double spring_stiffness = 0.0;        ///< k, Nm/rad; > 0 and 4 J N^2 k <= D^2, see rotor_damping
  double spring_damping = 0.0;          ///< b, Nms/rad; >= 0
  double travel = 0.0;                  ///< rad: positions run over [0, travel]; > 0
  double stop_stiffness = 0.0;          ///< of the load's end stops, Nm/rad; stalled, it may press in <= 1 % of travel
  double stop_damping = 0.0;            ///< of the end stops, Nms/rad; >= 0
  bool rigid = false;                   ///< no spring; its stiffness and damping are unused
  double torque_time_constant_s = 0.0;  ///< tau of a rigid drive, > 0
  double current_limit_A = std::numeric_limits<double>::infinity();  ///< of a rigid drive's commands, beside V_max / R
};

/// State of the integration.
struct ElectricState {
  double position = 0.0;    ///< x of the load, rad
  double velocity = 0.0;    ///< v of the load, rad/s
  double deflection = 0.0;  ///< delta of the spring, rad; 0 of a rigid drive
  double rotor = 0.0;       ///< w, rotor speed over the gear ratio, rad/s; unused by a rigid drive
  double current_A = 0.0;   ///< i
};

/// Energy of an electric actuator over a time, J.
struct ElectricAccount {
  double drawn_J = 0.0;  ///< from its supply, V i
  double work_J = 0.0;   ///< done on the mechanism
};

/// As runge_kutta.hpp asks of a state.
template <class Sum>
ElectricState assemble(const ElectricState*, Sum sum) noexcept {
  return {sum([](const ElectricState& k) noexcept { return k.position; }),
          sum([](const ElectricState& k) noexcept { return k.velocity; }),
          sum([](const ElectricState& k) noexcept { return k.deflection; }),
          sum([](const ElectricState& k) noexcept { return k.rotor; }),
          sum([](const ElectricState& k) noexcept { return k.current_A; })};
}
inline bool finite(const ElectricState& s) noexcept {
  return std::isfinite(s.position) && std::isfinite(s.velocity) && std::isfinite(s.deflection) &&
         std::isfinite(s.rotor) && std::isfinite(s.current_A);
}

/// Refuses values no machine has and springs too stiff for the model in [x v T], naming every one.
Result<Done> validate(const ElectricParams& actuator);
Result<Done> validate(const ElectricParams& actuator, const ElectricState& state);

/// V_max / R or the limit of the current, A: largest command of the drive.
inline double current_max_A(const ElectricParams& a) noexcept {
  return std::min(a.current_limit_A, a.supply_voltage_V / a.winding_resistance_Ohm);
}

/// N K times the largest command, Nm: at rest.
inline double stall_torque(const ElectricParams& a) noexcept {
  return a.gear_ratio * a.torque_constant_Nm_A * current_max_A(a);
}

/// V_max / (N K), rad/s of the output: the natural unit of velocity.
inline double no_load_speed(const ElectricParams& a) noexcept {
  return a.supply_voltage_V / (a.gear_ratio * a.torque_constant_Nm_A);
}

/// D = d_r + (N K)^2 / R, Nms/rad: damping of the rotor by friction and back-EMF.
inline double rotor_damping(const ElectricParams& a) noexcept {
  const double output_constant = a.gear_ratio * a.torque_constant_Nm_A;
  return a.damping + output_constant * output_constant / a.winding_resistance_Ohm;
}

/// J N^2, kg m^2: the rotor as the joint feels it, a robot description's armature.
inline double armature_kg_m2(const ElectricParams& a) noexcept {
  return a.rotor_inertia_kg_m2 * a.gear_ratio * a.gear_ratio;
}

/// D^2 / (4 J N^2), Nm/rad: with a stiffer spring the rotor oscillates, and (x, v, T) do not describe the joint.
inline double stiffest_spring_Nm_rad(const ElectricParams& a) noexcept {
  return rotor_damping(a) * rotor_damping(a) / (4.0 * armature_kg_m2(a));
}

/// J N^2 (2 pi 100 Hz)^2, Nm/rad: on a stiffer spring the rotor oscillates so fast that the drive counts as rigid.
inline double softest_rigid_spring_Nm_rad(const ElectricParams& a) noexcept {
  constexpr double kRigidRate_1_s = 2.0 * std::numbers::pi * 100.0;
  return armature_kg_m2(a) * kRigidRate_1_s * kRigidRate_1_s;
}

/// Rest at `position` under `external_force` on the load (Nm): T = C (x - x_eq) - T_ext, held by the winding.
ElectricState equilibrium(const ElectricParams& actuator, const LoadParams& load, double position,
                          double external_force);

/// Model in the torque sensor's reading, states (x, v, T), input u, with rotor and winding in equilibrium:
///   w = (N K u - T) / D,   (1 + b/D) T' = k (w - v) - b v',   v' as above.
/// Relative error of the force's rate: of the order of J N^2 k / D^2 (at most 1/4, see validate) and L k / (R D).
/// Coulomb friction is a bias. Needs m_l > 0. A rigid drive's model is exact but for friction and limits:
///   tau T' = N K u - T,   (m_l + J N^2) v' as above with d_l + d_r.
LinearModel linearise_load_cell_force(const ElectricParams& actuator, const LoadParams& load);

/// Exact Jacobian, states as in ElectricState, at a rotor speed (rad/s), away from the end stops. The drive has a
/// spring.
StateSpace<5> linearise_full(const ElectricParams& actuator, const LoadParams& load, double rotor);

/// Right-hand side of the equations above; +, -, *, / and sqrt only.
class ElectricEquations {
 public:
  using State = ElectricState;
  struct Input {
    double command_A;       ///< within the drive's limits
    double external_force;  ///< Nm
  };

  ElectricEquations(const ElectricParams& actuator, const LoadParams& load) noexcept
      : actuator_(actuator), load_(load) {}

  void set_load(const LoadParams& load) noexcept { load_ = load; }

  ElectricState derivative(const ElectricState& s, const Input& input) const noexcept {
    const ElectricParams& a = actuator_;
    if (a.rigid) {
      return rigid_derivative(s, input);
    }
    const double output_constant = a.gear_ratio * a.torque_constant_Nm_A;
    const double torque = spring_torque(s);
    const double rotor_torque = output_constant * s.current_A - a.damping * s.rotor - dry_friction(s.rotor) - torque;
    const double load_torque = torque - load_.damping * s.velocity -
                               load_.stiffness * (s.position - load_.equilibrium_position) + input.external_force +
                               stop_force(s);
    return {.position = s.velocity,
            .velocity = load_torque / load_.mass,
            .deflection = s.rotor - s.velocity,
            .rotor = rotor_torque / (a.rotor_inertia_kg_m2 * a.gear_ratio * a.gear_ratio),
            .current_A = (a.winding_resistance_Ohm * (input.command_A - s.current_A) - output_constant * s.rotor) /
                         a.winding_inductance_H};
  }

  /// T, the sensor's reading, Nm: the spring's torque, or that of a rigid drive's motor.
  double sensed_torque(const ElectricState& s) const noexcept {
    return actuator_.rigid ? actuator_.gear_ratio * actuator_.torque_constant_Nm_A * s.current_A : spring_torque(s);
  }

  /// Torque on a mechanism without its inertia, Nm: a rigid drive's friction acts on it.
  double mechanism_torque(const ElectricState& s) const noexcept {
    const double friction = actuator_.rigid ? actuator_.damping * s.velocity + dry_friction(s.velocity) : 0.0;
    return sensed_torque(s) - friction + stop_force(s);
  }

  /// Voltage of the drive, V.
  double voltage_V(const ElectricState& s, double command_A) const noexcept {
    const ElectricParams& a = actuator_;
    return a.rigid ? a.winding_resistance_Ohm * s.current_A + a.gear_ratio * a.torque_constant_Nm_A * s.velocity
                   : a.winding_resistance_Ohm * command_A;
  }

  double spring_torque(const ElectricState& s) const noexcept {
    return actuator_.spring_stiffness * s.deflection + actuator_.spring_damping * (s.rotor - s.velocity);
  }

  /// T_c phi(w), phi = w / sqrt(w^2 + w_s^2): smooth, odd, of the sign of w.
  double dry_friction(double rotor) const noexcept {
    return coulomb_friction(actuator_.coulomb, rotor, actuator_.slip_velocity);
  }

  /// Force of the end stops on the load: only pushes inward.
  double stop_force(const ElectricState& s) const noexcept {
    const double beyond = s.position - actuator_.travel;
    return s.position < 0.0 ? stop_push(-s.position, -s.velocity) : beyond > 0.0 ? -stop_push(beyond, s.velocity) : 0.0;
  }

  const ElectricParams& actuator() const noexcept { return actuator_; }
  const LoadParams& load() const noexcept { return load_; }

 private:
  ElectricState rigid_derivative(const ElectricState& s, const Input& input) const noexcept {
    const ElectricParams& a = actuator_;
    const double torque = mechanism_torque(s) - load_.damping * s.velocity -
                          load_.stiffness * (s.position - load_.equilibrium_position) + input.external_force;
    const double back_emf_V = a.gear_ratio * a.torque_constant_Nm_A * s.velocity;
    const double most_A = current_max_A(a);
    const auto driven_A = [&](double voltage_V) {
      return std::clamp((voltage_V - back_emf_V) / a.winding_resistance_Ohm, -most_A, most_A);
    };
    const double command_A = std::clamp(input.command_A, driven_A(-a.supply_voltage_V), driven_A(a.supply_voltage_V));
    return {.position = s.velocity,
            .velocity = torque / (load_.mass + armature_kg_m2(a)),
            .deflection = 0.0,
            .rotor = 0.0,
            .current_A = (command_A - s.current_A) / a.torque_time_constant_s};
  }

  double stop_push(double depth, double approach_speed) const noexcept {
    // engaged over the first thousandth of the travel
    return plant::stop_push(depth, approach_speed, depth * (1000.0 / actuator_.travel), actuator_.stop_stiffness,
                            actuator_.stop_damping);
  }

  ElectricParams actuator_;
  LoadParams load_;
};

}  // namespace farrier::plant
