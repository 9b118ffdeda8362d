#pragma once

#include "plant/actuator.hpp"

namespace farrier::plant {

/// The load's mass without the part that hangs on it by a spring.
inline double rigid_mass(const LoadParams& load) noexcept { return load.mass * (1.0 - load.flexible.share); }

/// Right of the load cell: force gives motion, Hubacher (2014), (2.24). The piston moves with the load, so that its
/// mass and damping are here too, (2.25), (2.26). N, m, m/s, m/s^2 or Nm, rad, rad/s, rad/s^2.
class LoadEquations {
 public:
  LoadEquations(const LoadParams& load, double piston_mass, double piston_damping) noexcept
      : piston_mass_(piston_mass), piston_damping_(piston_damping) {
    set(load);
  }

  void set(const LoadParams& load) noexcept {
    params_ = load;
    inverse_mass_ = 1.0 / (rigid_mass(load) + piston_mass_);  // (2.25)
    total_damping_ = load.damping + piston_damping_;          // (2.26)
  }

  /// (2.24) (m_l + m_p) a = F_h - (d_l + d_p) v - C (x - x_eq) + F_ext + F_stop
  double acceleration(double position, double velocity, double hydraulic_force, double load_force,
                      double stop_force) const noexcept {
    const double force = hydraulic_force - total_damping_ * velocity -
                         params_.stiffness * (position - params_.equilibrium_position) + load_force + stop_force;
    return force * inverse_mass_;
  }

  const LoadParams& params() const noexcept { return params_; }

 private:
  LoadParams params_;
  double piston_mass_;
  double piston_damping_;
  double inverse_mass_ = 0.0;
  double total_damping_ = 0.0;
};

}  // namespace farrier::plant
