#pragma once

#include <Eigen/Core>
#include <optional>

#include "config/visitor.hpp"

namespace farrier::robot {

/// Inertia tensor about the centre of mass, kg m^2, tensor elements (not products of inertia with their sign turned).
struct Inertia {
  double xx_kg_m2 = 0.0;
  double yy_kg_m2 = 0.0;
  double zz_kg_m2 = 0.0;
  double xy_kg_m2 = 0.0;
  double xz_kg_m2 = 0.0;
  double yz_kg_m2 = 0.0;

  Eigen::Matrix3d tensor_kg_m2() const noexcept;
};

/// A link in the frame of its joint: the joint turns about z, x points along the leg to the next joint. The hip turns
/// about the HAA axis; its z runs along it, the way by which a positive angle turns the leg inwards.
struct Link {
  double mass_kg = 0.0;
  double com_x_m = 0.0;
  double com_y_m = 0.0;
  double com_z_m = 0.0;
  Inertia inertia;
  config::Place place;
};

/// The part of the trunk that touches the ground when the robot falls: a box along the trunk's axes, in the middle of
/// its width.
struct TrunkBox {
  double length_m = 0.0;
  double width_m = 0.0;
  double height_m = 0.0;
  double x_m = 0.0;  ///< middle, forward of the trunk's origin
  double z_m = 0.0;  ///< middle, above it
};

/// The trunk's mass distribution in its frame: x forward, y left, z up. Its mass is Body::trunk_mass_kg.
struct Trunk {
  double com_x_m = 0.0;
  double com_y_m = 0.0;
  double com_z_m = 0.0;
  Inertia inertia;
  std::optional<TrunkBox> box;  ///< none: the trunk passes through the ground
  config::Place place;
};

/// Rigid body of the robot; legs are mirror images of each other, links given for a front left one.
struct Body {
  double gravity_m_s2 = 9.81;
  double trunk_mass_kg = 0.0;
  double hip_offset_m = 0.0;
  double upper_leg_m = 0.0;
  double lower_leg_m = 0.0;
  std::optional<Trunk> trunk;           ///< of a robot that can be simulated as rigid bodies
  std::optional<double> foot_radius_m;  ///< of the same
  double knee_radius_m = 0.0;
  double joint_damping_Nms_rad = 0.0;
  double known_damping_share = 0.0;
  Link hip;
  Link upper_leg;
  Link lower_leg;
  config::Place place;
};

void declare(config::Visitor& v, Inertia& inertia);
void declare(config::Visitor& v, Link& link);
void declare(config::Visitor& v, TrunkBox& box);
void declare(config::Visitor& v, Trunk& trunk);
void declare(config::Visitor& v, Body& body);

}  // namespace farrier::robot
