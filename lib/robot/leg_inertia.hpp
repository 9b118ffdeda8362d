#pragma once

#include <cstddef>

#include "robot/sections/body_section.hpp"

namespace farrier::robot {

/// Inertia of a whole leg about its HAA axis, kg m^2, with HFE and KFE held at these angles (front leg, rad). The HAA
/// angle does not matter. Derivation in the source.
double leg_inertia_about_haa_kg_m2(const Body& body, double hfe_rad, double kfe_rad) noexcept;

/// Mass of one leg, kg.
double leg_mass_kg(const Body& body) noexcept;

/// Weight of a robot with so many legs, N.
double robot_weight_N(const Body& body, std::size_t legs) noexcept;

}  // namespace farrier::robot
