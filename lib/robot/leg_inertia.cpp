#include "robot/leg_inertia.hpp"

#include <cmath>

#include "core/portable_math.hpp"

namespace farrier::robot {
namespace {

// The HAA axis u lies in the leg's plane, at right angles to the hanging leg. A link turned by q has the axes
//   e_x = cos q down + sin q u,   e_y = -sin q down + cos q u.
// So u = sin q e_x + cos q e_y. With the link's joint at depth h below the axis (Steiner):
//   J = u' I u + m d^2,   d = h + x_com cos q - y_com sin q.
double link_inertia(const Link& link, double joint_depth_m, double angle_rad) noexcept {
  const double s = portable::sin(angle_rad);
  const double c = portable::cos(angle_rad);
  const Inertia& i = link.inertia;
  const double about_com = i.xx_kg_m2 * s * s + i.yy_kg_m2 * c * c + 2.0 * i.xy_kg_m2 * s * c;
  const double depth = joint_depth_m + link.com_x_m * c - link.com_y_m * s;
  return about_com + link.mass_kg * depth * depth;
}

}  // namespace

double leg_inertia_about_haa_kg_m2(const Body& body, double hfe_rad, double kfe_rad) noexcept {
  // The hip itself turns about its z axis, which is u.
  const Link& hip = body.hip;
  const double hip_inertia =
      hip.inertia.zz_kg_m2 + hip.mass_kg * (hip.com_x_m * hip.com_x_m + hip.com_y_m * hip.com_y_m);
  const double knee_depth = body.hip_offset_m + body.upper_leg_m * portable::cos(hfe_rad);
  return hip_inertia + link_inertia(body.upper_leg, body.hip_offset_m, hfe_rad) +
         link_inertia(body.lower_leg, knee_depth, hfe_rad + kfe_rad);
}

double leg_mass_kg(const Body& body) noexcept {
  return body.hip.mass_kg + body.upper_leg.mass_kg + body.lower_leg.mass_kg;
}

double robot_weight_N(const Body& body, std::size_t legs) noexcept {
  return body.gravity_m_s2 * (body.trunk_mass_kg + static_cast<double>(legs) * leg_mass_kg(body));
}

}  // namespace farrier::robot
