#include "robot/sections/body_section.hpp"

#include "body/model/body_model.hpp"

namespace farrier::robot {

using config::kInitial;
using config::Visitor;

void declare(Visitor& v, Inertia& i) {
  v.number("xx_kg_m2", i.xx_kg_m2, {0, 1e3}, "About x through the centre of mass.");
  v.number("yy_kg_m2", i.yy_kg_m2, {0, 1e3}, "About y through the centre of mass.");
  v.number("zz_kg_m2", i.zz_kg_m2, {0, 1e3}, "About z through the centre of mass.");
  v.number("xy_kg_m2", i.xy_kg_m2, {-1e3, 1e3}, kInitial, "Off-diagonal element of the tensor.");
  v.number("xz_kg_m2", i.xz_kg_m2, {-1e3, 1e3}, kInitial, "Off-diagonal element of the tensor.");
  v.number("yz_kg_m2", i.yz_kg_m2, {-1e3, 1e3}, kInitial, "Off-diagonal element of the tensor.");
  v.check(body::is_possible_tensor(i.tensor_kg_m2()), "", std::string("is a tensor that ") + body::kImpossibleTensor);
}

Eigen::Matrix3d Inertia::tensor_kg_m2() const noexcept {
  Eigen::Matrix3d tensor;
  tensor << xx_kg_m2, xy_kg_m2, xz_kg_m2, xy_kg_m2, yy_kg_m2, yz_kg_m2, xz_kg_m2, yz_kg_m2, zz_kg_m2;
  return tensor;
}

void declare(Visitor& v, Link& l) {
  v.here(l.place);
  v.number("mass_kg", l.mass_kg, {0, 1e3}, "Mass.");
  v.number("com_x_m", l.com_x_m, {-5, 5}, "Centre of mass along the leg.");
  v.number("com_y_m", l.com_y_m, {-5, 5}, kInitial, "Centre of mass across the leg, at right angles to the axis.");
  v.number("com_z_m", l.com_z_m, {-5, 5}, kInitial, "Centre of mass along the axis.");
  v.group("inertia", l.inertia, "Inertia tensor about the centre of mass.");
}

void declare(Visitor& v, TrunkBox& b) {
  v.number("length_m", b.length_m, {1e-3, 10}, "Extent forward.");
  v.number("width_m", b.width_m, {1e-3, 10}, "Extent to the left.");
  v.number("height_m", b.height_m, {1e-3, 10}, "Extent upwards.");
  v.number("x_m", b.x_m, {-5, 5}, kInitial, "Middle, forward of the trunk's origin.");
  v.number("z_m", b.z_m, {-5, 5}, kInitial, "Middle, above it.");
}

void declare(Visitor& v, Trunk& t) {
  v.here(t.place);
  v.number("com_x_m", t.com_x_m, {-5, 5}, "Centre of mass, forward of the trunk's origin.");
  v.number("com_y_m", t.com_y_m, {-5, 5}, kInitial, "Centre of mass, to the left of it.");
  v.number("com_z_m", t.com_z_m, {-5, 5}, kInitial, "Centre of mass, above it.");
  v.group("inertia", t.inertia, "Inertia tensor about the centre of mass: x forward, y left, z up.");
  v.group("box", t.box, "What of the trunk meets the ground when the robot falls; absent: nothing does.");
}

void declare(Visitor& v, Body& b) {
  v.here(b.place);
  v.number("gravity_m_s2", b.gravity_m_s2, {0, 30}, kInitial, "Acceleration of gravity.");
  v.number("trunk_mass_kg", b.trunk_mass_kg, {0, 1e4}, "Everything but the legs.");
  v.group("trunk", b.trunk,
          "Mass distribution of the trunk; absent for a robot that is simulated joint by joint only.");
  v.number("foot_radius_m", b.foot_radius_m, {1e-3, 0.5}, "Radius of the foot's sphere; given with trunk.");
  v.number("knee_radius_m", b.knee_radius_m, {0, 0.5}, kInitial,
           "Radius of a sphere about the knee that meets the ground when the robot falls; 0: none.");
  v.number("joint_damping_Nms_rad", b.joint_damping_Nms_rad, {0, 1e3}, kInitial,
           "Viscous friction of a joint's bearings, on a ground.");
  v.number("known_damping_share", b.known_damping_share, {0, 1}, kInitial,
           "Share of that friction that locomotion counts, in the torques it asks for and in the forces it feels.");
  v.number("hip_offset_m", b.hip_offset_m, {0, 5}, "HAA axis to HFE axis.");
  v.number("upper_leg_m", b.upper_leg_m, {1e-2, 5}, "HFE axis to KFE axis.");
  v.number("lower_leg_m", b.lower_leg_m, {1e-2, 5}, "KFE axis to the centre of the foot.");
  v.group("hip", b.hip, "Hip assembly, turning about the HAA axis.");
  v.group("upper_leg", b.upper_leg, "Upper leg, turning about the HFE axis.");
  v.group("lower_leg", b.lower_leg, "Lower leg, turning about the KFE axis.");
}

}  // namespace farrier::robot
