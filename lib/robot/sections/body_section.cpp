#include "robot/sections/body_section.hpp"

namespace farrier::robot {

using config::kInitial;
using config::Visitor;

void declare(Visitor& v, Inertia& i) {
  v.number("xx_kg_m2", i.xx_kg_m2, {0, 1e3}, "About x through the centre of mass.");
  v.number("yy_kg_m2", i.yy_kg_m2, {0, 1e3}, "About y through the centre of mass.");
  v.number("zz_kg_m2", i.zz_kg_m2, {0, 1e3}, "About z through the centre of mass.");
  v.number("xy_kg_m2", i.xy_kg_m2, {-1e3, 1e3}, kInitial, "Off-diagonal element of the tensor.");
}

void declare(Visitor& v, Link& l) {
  v.number("mass_kg", l.mass_kg, {0, 1e3}, "Mass.");
  v.number("com_x_m", l.com_x_m, {-5, 5}, "Centre of mass along the leg.");
  v.number("com_y_m", l.com_y_m, {-5, 5}, kInitial, "Centre of mass across the leg, at right angles to the axis.");
  v.group("inertia", l.inertia, "Inertia tensor about the centre of mass.");
}

void declare(Visitor& v, Body& b) {
  v.number("gravity_m_s2", b.gravity_m_s2, {0, 30}, kInitial, "Acceleration of gravity.");
  v.number("trunk_mass_kg", b.trunk_mass_kg, {0, 1e4}, "Everything but the legs.");
  v.number("hip_offset_m", b.hip_offset_m, {0, 5}, "HAA axis to HFE axis.");
  v.number("upper_leg_m", b.upper_leg_m, {1e-2, 5}, "HFE axis to KFE axis.");
  v.number("lower_leg_m", b.lower_leg_m, {1e-2, 5}, "KFE axis to the centre of the foot.");
  v.group("hip", b.hip, "Hip assembly, turning about the HAA axis.");
  v.group("upper_leg", b.upper_leg, "Upper leg, turning about the HFE axis.");
  v.group("lower_leg", b.lower_leg, "Lower leg, turning about the KFE axis.");
}

}  // namespace farrier::robot
