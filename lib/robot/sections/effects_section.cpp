#include "robot/sections/effects_section.hpp"

namespace farrier::robot {

using config::Default;
using config::Visitor;

void declare(Visitor& v, SpoolSection& s) {
  v.number("natural_frequency_rad_s", s.natural_frequency_rad_s, {10, 1e5}, Default{1570.0},
           "Natural frequency of the spool, omega_v (2.19).");
  v.number("damping", s.damping, {0.01, 10}, Default{0.5}, "Its damping, D_v.");
  v.flag("on", s.on, Default{true}, "Off, the spool follows its command at once.");
}

void declare(Visitor& v, LineSection& l) {
  v.number("length_m", l.length_m, {0.01, 10}, "From valve to chamber.");
  v.number("bore_m", l.bore_m, {5e-4, 0.05}, "Inner diameter.");
  v.number("density_kg_m3", l.density_kg_m3, {500, 2000}, Default{870.0}, "Of the oil.");
  v.number("viscosity_Pa_s", l.viscosity_Pa_s, {0, 1}, Default{0.04}, "Dynamic viscosity of the oil.");
  v.number("loss_coefficient", l.loss_coefficient, {0, 1000}, Default{0.0},
           "Loss of bends and fittings together, in velocity heads.");
}

void declare(Visitor& v, DryFrictionSection& f) {
  v.number("coulomb_N", f.coulomb_N, {1e-3, 1e5}, "Friction in motion, F_c (9.3.1).");
  v.number("static_N", f.static_N, {1e-3, 1e5}, "Friction that holds at rest, F_s.");
  v.number("stribeck_velocity_m_s", f.stribeck_velocity_m_s, {1e-5, 10}, Default{0.01},
           "Speed over which friction falls from static to Coulomb, v_s.");
  v.number("presliding_m", f.presliding_m, {1e-7, 1e-3}, Default{1e-5},
           "Way over which the contact bends before it slides: static_N over its stiffness.");
  v.check(f.static_N >= f.coulomb_N, "static_N", "must not be below coulomb_N");
}

void declare(Visitor& v, SensorSection& s) {
  v.here(s.place);
  v.number("position_filter_Hz", s.position_filter_Hz, {0, 1e4}, Default{0.0},
           "Cut-off of the low-pass on the measured position; 0: none.");
  v.number("velocity_filter_Hz", s.velocity_filter_Hz, {0, 1e4}, Default{0.0}, "The same on the velocity.");
  v.number("force_filter_Hz", s.force_filter_Hz, {0, 1e4}, Default{0.0}, "The same on the force.");
  v.integer("filter_order", s.filter_order, {1, 2}, Default{2}, "Order of these filters.");
  v.number("filter_damping", s.filter_damping, {0.1, 5}, Default{0.7071}, "Their damping where the order is 2.");
  v.integer("oversampling", s.oversampling, {1, 64}, Default{1},
            "Conversions per tick; their mean is the sample, and noise is that of one conversion.");
  v.number("anti_alias_Hz", s.anti_alias_Hz, {0, 1e5}, Default{0.0},
           "Cut-off of the analog low-pass of order 2 before each conversion; 0: none.");
  v.number("position_step_m", s.position_step_m, {0, 1e-3}, Default{0.0},
           "Resolution of the position sensor; 0: as fine as numbers are.");
}

}  // namespace farrier::robot
