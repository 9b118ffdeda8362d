#pragma once

#include "config/visitor.hpp"

namespace farrier::robot {

// Sections of a robot file beyond the thesis's model that are measures of parts: the lines before the chambers and the
// filters of sensors. Each group may be absent. Effects of joints are in joint_effects_section.hpp.

struct LineSection {
  double length_m = 0.0;
  double bore_m = 0.0;
  double density_kg_m3 = 870.0;
  double viscosity_Pa_s = 0.04;
  double loss_coefficient = 0.0;
};

struct SensorSection {
  double position_filter_Hz = 0.0;
  double velocity_filter_Hz = 0.0;
  double force_filter_Hz = 0.0;
  int filter_order = 2;
  double filter_damping = 0.7071;
  int oversampling = 1;
  double anti_alias_Hz = 0.0;
  double position_step_m = 0.0;
  config::Place place;
};

void declare(config::Visitor& v, LineSection& line);
void declare(config::Visitor& v, SensorSection& sensors);

}  // namespace farrier::robot
