#include "robot/sections/effects_section.hpp"

namespace farrier::robot {

using config::kInitial;
using config::Visitor;

void declare(Visitor& v, LineSection& l) {
  v.number("length_m", l.length_m, {0.01, 10}, "From valve to chamber.");
  v.number("bore_m", l.bore_m, {5e-4, 0.05}, "Inner diameter.");
  v.number("density_kg_m3", l.density_kg_m3, {500, 2000}, kInitial, "Of the oil.");
  v.number("viscosity_Pa_s", l.viscosity_Pa_s, {0, 1}, kInitial, "Dynamic viscosity of the oil.");
  v.number("loss_coefficient", l.loss_coefficient, {0, 1000}, kInitial,
           "Loss of bends and fittings together, in velocity heads.");
}

void declare(Visitor& v, SensorSection& s) {
  v.here(s.place);
  v.number("position_filter_Hz", s.position_filter_Hz, {0, 1e4}, kInitial,
           "Cut-off of the low-pass on the measured position; 0: none.");
  v.number("velocity_filter_Hz", s.velocity_filter_Hz, {0, 1e4}, kInitial, "The same on the velocity.");
  v.number("force_filter_Hz", s.force_filter_Hz, {0, 1e4}, kInitial, "The same on the force.");
  v.integer("filter_order", s.filter_order, {1, 2}, kInitial, "Order of these filters.");
  v.number("filter_damping", s.filter_damping, {0.1, 5}, kInitial, "Their damping where the order is 2.");
  v.integer("oversampling", s.oversampling, {1, 64}, kInitial,
            "Conversions per tick; their mean is the sample, and noise is that of one conversion.");
  v.number("anti_alias_Hz", s.anti_alias_Hz, {0, 1e5}, kInitial,
           "Cut-off of the analog low-pass of order 2 before each conversion; 0: none.");
  v.number("position_step_m", s.position_step_m, {0, 1e-3}, kInitial,
           "Resolution of the position sensor; 0: as fine as numbers are.");
}

}  // namespace farrier::robot
