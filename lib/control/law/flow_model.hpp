#pragma once

#include "plant/joint_physics.hpp"

namespace farrier::control {

/// Joint as a controller believes it to be, cheap enough to run several times a tick: Hubacher (2014) (2.30a), (2.30b)
/// with the load of JointPhysics; pressures stop at zero, no voids and no end stops. Position, velocity and pressures
/// as plant::State has them. The fastest rate determines the number of substeps, at most 10 per period.
class FlowModel {
 public:
  /// Values in the ranges that ActuatorParams and JointPhysics state; `period_s` > 0.
  /// `slack_position`: where the load's spring is slack, x_eq, m or rad from fully retracted.
  FlowModel(const plant::ActuatorParams& actuator, const plant::JointPhysics& physics, double slack_position,
            double period_s) noexcept;

  /// Estimated disturbances beyond the physics, held over the period.
  struct Disturbance {
    double load_force = 0.0;        ///< on the load, N or Nm
    double force_rate_per_s = 0.0;  ///< of the hydraulic force, by an unexplained flow, N/s or Nm/s
  };

  /// State one period later under a held current (Runge and Kutta's fourth order in equal substeps).
  plant::State advance(const plant::State& s, double valve_current_A, const Disturbance& d) const noexcept;

  /// F_s = F_h - d_p v - m_p a, (2.22).
  double load_cell_force(const plant::State& s, const Disturbance& d) const noexcept;

  /// Shifts the chamber pressures so that the load cell's force becomes `force`, as oil moved through the valve would.
  void set_force(plant::State& s, double force, const Disturbance& d) const noexcept;

  /// m_l + m_p, kg or kg m^2.
  double moving_mass() const noexcept { return 1.0 / inverse_mass_; }

 private:
  plant::State derivative(const plant::State& s, double flow_gain, double port_a, double port_b,
                          const Disturbance& d) const noexcept;
  double load_and_piston_force(const plant::State& s, const Disturbance& d) const noexcept;

  plant::ActuatorParams actuator_;
  plant::JointPhysics physics_;
  double slack_position_;
  double inverse_mass_;
  double friction_speed_;
  double smallest_volume_m3_;
  int substeps_;
  double substep_s_;
};

}  // namespace farrier::control
