#include "robot/body_model.hpp"

namespace farrier::robot {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// `axes` has the link's x, y and z as columns, in the trunk's axes.
body::RigidInertia turned(const Link& link, const Matrix3d& axes) {
  return {link.mass_kg, axes * Vector3d(link.com_x_m, link.com_y_m, link.com_z_m),
          axes * link.inertia.tensor_kg_m2() * axes.transpose()};
}

// Hind legs are images of the front legs in the plane x = 0, right legs of the left ones in y = 0.
body::RigidInertia mirrored(const body::RigidInertia& inertia, const Leg& leg) {
  const Matrix3d mirror = Vector3d(leg.front ? 1.0 : -1.0, leg.left ? 1.0 : -1.0, 1.0).asDiagonal();
  return {inertia.mass_kg, mirror * inertia.com_m, mirror * inertia.tensor_kg_m2 * mirror};
}

body::Link make_link(const Vector3d& hinge_m, const Vector3d& axis, const body::RigidInertia& inertia,
                     const Body& body) {
  body::Link link;
  link.hinge_m = hinge_m;
  link.axis = axis;
  link.damping_Nms_rad = body.joint_damping_Nms_rad;
  link.known_damping_Nms_rad = body.known_damping_share * body.joint_damping_Nms_rad;
  link.inertia = inertia;
  return link;
}

body::LegModel make_leg(const std::string& name, const Leg& leg, const Body& body) {
  const Vector3d hip_m(leg.hip_position_m[0], leg.hip_position_m[1], leg.hip_position_m[2]);
  const Vector3d haa_axis = leg.left ? -Vector3d::UnitX() : Vector3d(Vector3d::UnitX());
  const Vector3d down = -Vector3d::UnitZ();
  return {.name = name,
          .links = {make_link(hip_m, haa_axis, mirrored(hip_inertia(body.hip), leg), body),
                    make_link(body.hip_offset_m * down, Vector3d::UnitY(),
                              mirrored(leg_link_inertia(body.upper_leg), leg), body),
                    make_link(body.upper_leg_m * down, Vector3d::UnitY(),
                              mirrored(leg_link_inertia(body.lower_leg), leg), body)},
          .foot_m = body.lower_leg_m * down,
          .foot_radius_m = *body.foot_radius_m,
          .knee_radius_m = body.knee_radius_m};
}

std::optional<body::TrunkBox> trunk_box(const Trunk& trunk) {
  if (!trunk.box) {
    return std::nullopt;
  }
  const TrunkBox& box = *trunk.box;
  return body::TrunkBox{.centre_m = {box.x_m, 0.0, box.z_m},
                        .half_extents_m = 0.5 * Vector3d(box.length_m, box.width_m, box.height_m)};
}

}  // namespace

body::RigidInertia trunk_inertia(const Body& body) {
  const Trunk& trunk = *body.trunk;
  return {body.trunk_mass_kg, {trunk.com_x_m, trunk.com_y_m, trunk.com_z_m}, trunk.inertia.tensor_kg_m2()};
}

// The hip's z is the HAA axis, which points backward on the left; x is down and y inward.
body::RigidInertia hip_inertia(const Link& hip) {
  Matrix3d axes;
  axes << -Vector3d::UnitZ(), -Vector3d::UnitY(), -Vector3d::UnitX();
  return turned(hip, axes);
}

// The z of upper and lower leg is the axis of HFE and KFE, to the left; x is down and y backward.
body::RigidInertia leg_link_inertia(const Link& upper_or_lower_leg) {
  Matrix3d axes;
  axes << -Vector3d::UnitZ(), -Vector3d::UnitX(), Vector3d::UnitY();
  return turned(upper_or_lower_leg, axes);
}

std::optional<body::BodyModel> make_body_model(const RobotFile& file) {
  if (!file.body || !file.body->trunk) {
    return std::nullopt;
  }
  body::BodyModel model{.trunk = trunk_inertia(*file.body),
                        .legs = {},
                        .box = trunk_box(*file.body->trunk),
                        .gravity_m_s2 = file.body->gravity_m_s2};
  for (const auto& [name, leg] : file.legs) {
    model.legs.push_back(make_leg(name, leg, *file.body));
  }
  return model;
}

}  // namespace farrier::robot
