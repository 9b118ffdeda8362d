#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "plant/actuator.hpp"

namespace farrier::plant {

/// Properties of a joint that change or are not known beforehand, actuator coordinates (N, m of a cylinder; Nm, rad of
/// a motor). The load cell splits it in two, Hubacher (2014) (2.22). The first five are the load, right of the cell,
/// m_l a = F_s - d_l v - F_c sign(v) - C (x - x_eq) + F_bias. The last four are the valve and the oil, left of it.
struct JointPhysics {
  double load_mass = 0.0;     ///< m_l, kg or kg m^2; >= 0
  double damping = 0.0;       ///< d_l, Ns/m or Nms/rad; >= 0
  double coulomb = 0.0;       ///< F_c, N or Nm; >= 0
  double stiffness = 0.0;     ///< C, N/m or Nm/rad; >= 0
  double bias_force = 0.0;    ///< F_bias on the load, positive along +position: body weight and the like, N or Nm
  double valve_gain = 0.0;    ///< K_v, m^3/s/(A sqrt(Pa)); > 0
  double bulk_modulus = 0.0;  ///< beta_e, Pa; > 0
  double leakage = 0.0;       ///< between the chambers, m^3/s/Pa; >= 0
  double overlap_A = 0.0;     ///< current that moves the spool over its overlap, A; >= 0
};

inline constexpr std::size_t kPhysicsCount = 9;
inline constexpr std::size_t kBiasForce = 4;  ///< place of the only one that has a sign

/// In the order of the declaration, as physics is transmitted.
inline std::array<double, kPhysicsCount> values_of(const JointPhysics& p) noexcept {
  return {p.load_mass,  p.damping,      p.coulomb, p.stiffness, p.bias_force,
          p.valve_gain, p.bulk_modulus, p.leakage, p.overlap_A};
}

inline JointPhysics physics_of(const std::array<double, kPhysicsCount>& v) noexcept {
  return {v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8]};
}

/// Name of the first that is not finite or out of its range, a load without mass included; null for none.
inline const char* first_unphysical(const JointPhysics& p) noexcept {
  const std::array<double, kPhysicsCount> values = values_of(p);
  constexpr std::array kNames{"load_mass",  "damping",      "coulomb", "stiffness", "bias_force",
                              "valve_gain", "bulk_modulus", "leakage", "overlap_A"};
  constexpr std::array kAboveZero{true, false, false, false, false, true, true, false, false};
  for (std::size_t i = 0; i < kPhysicsCount; ++i) {
    const bool signed_value = i == kBiasForce;
    if (!std::isfinite(values[i]) || (!signed_value && values[i] < 0.0) || (kAboveZero[i] && values[i] == 0.0)) {
      return kNames[i];
    }
  }
  return nullptr;
}

/// Nominal physics: no Coulomb friction, no leakage, no bias force.
inline JointPhysics nominal_physics(const ActuatorParams& actuator, const LoadParams& load) noexcept {
  return {.load_mass = load.mass,
          .damping = load.damping,
          .stiffness = load.stiffness,
          .valve_gain = actuator.valve_gain,
          .bulk_modulus = actuator.bulk_modulus_Pa};
}

}  // namespace farrier::plant
