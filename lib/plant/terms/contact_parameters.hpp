#pragma once

#include "plant/dry_contact.hpp"
#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Share of the stroke over which contacts bend unless told: 10 um of 80 mm.
inline constexpr double kPreslidingShare = 1.25e-4;

/// Parameters of effects of friction.
inline constexpr std::array kContactParameters{
    Parameter{
        "coulomb_N", "coulomb_Nm", "N", "Nm", Scale::kForce, false, 1e-6, 0.5, {0.01, 0.05}, "Friction in motion."},
    Parameter{"breakaway_ratio",
              "breakaway_ratio",
              "1",
              "1",
              Scale::kOne,
              false,
              1.0,
              2.5,
              {1.3, 1.3},
              "Friction that holds at rest, over that in motion."},
    Parameter{"stribeck_velocity_m_s",
              "stribeck_velocity_rad_s",
              "m/s",
              "rad/s",
              Scale::kSpeed,
              false,
              0.001,
              0.1,
              {0.01, 0.01},
              "Speed over which the one falls to the other."},
    Parameter{"presliding_m",
              "presliding_rad",
              "m",
              "rad",
              Scale::kLength,
              false,
              1e-7,
              1e-2,
              {kPreslidingShare, kPreslidingShare},
              "Way over which the contact's bristles bend before it slides.",
              true},
    Parameter{"bristle_damping_Ns_m",
              "bristle_damping_Nms_rad",
              "Ns/m",
              "Nms/rad",
              Scale::kDamping,
              false,
              0.0,
              1.0,
              {0.0, 0.0},
              "Damping of the bristles, sigma_1.",
              true}};

/// The contact with those numbers of kContactParameters.
template <class T>
DryContact<T> contact_of(const T* fitted, const Scales& scales) noexcept {
  const T coulomb = fitted[0] * scales.of(Scale::kForce);
  return {coulomb, coulomb * fitted[1], fitted[2] * scales.of(Scale::kSpeed), fitted[3] * scales.of(Scale::kLength),
          fitted[4] * scales.of(Scale::kDamping)};
}

}  // namespace farrier::plant
