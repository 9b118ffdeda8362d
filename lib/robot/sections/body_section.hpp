#pragma once

#include <optional>

#include "config/visitor.hpp"

namespace farrier::robot {

/// Inertia tensor about the centre of mass, kg m^2, tensor elements (not products of inertia with their sign turned).
struct Inertia {
  double xx_kg_m2 = 0.0;
  double yy_kg_m2 = 0.0;
  double zz_kg_m2 = 0.0;
  double xy_kg_m2 = 0.0;
};

/// A link in the frame of its joint: the joint turns about z, x points along the leg to the next joint. The hip turns
/// about the HAA axis; its z runs along it.
struct Link {
  double mass_kg = 0.0;
  double com_x_m = 0.0;
  double com_y_m = 0.0;
  Inertia inertia;
};

/// Rigid body of the robot; legs are mirror images of each other, links given for a front left one.
struct Body {
  double gravity_m_s2 = 9.81;
  double trunk_mass_kg = 0.0;
  double hip_offset_m = 0.0;
  double upper_leg_m = 0.0;
  double lower_leg_m = 0.0;
  Link hip;
  Link upper_leg;
  Link lower_leg;
};

void declare(config::Visitor& v, Inertia& inertia);
void declare(config::Visitor& v, Link& link);
void declare(config::Visitor& v, Body& body);

}  // namespace farrier::robot
