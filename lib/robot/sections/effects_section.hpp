#pragma once

#include "config/visitor.hpp"

namespace farrier::robot {

// Sections of a robot file beyond the thesis's model: effects of valve, lines and guides, and filters of sensors. Each
// group may be absent; its effect is then off.

struct SpoolSection {
  double natural_frequency_rad_s = 1570.0;
  double damping = 0.5;
  bool on = true;
};

struct LineSection {
  double length_m = 0.0;
  double bore_m = 0.0;
  double density_kg_m3 = 870.0;
  double viscosity_Pa_s = 0.04;
  double loss_coefficient = 0.0;
};

struct DryFrictionSection {
  double coulomb_N = 0.0;
  double static_N = 0.0;
  double stribeck_velocity_m_s = 0.01;
  double presliding_m = 1e-5;
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

void declare(config::Visitor& v, SpoolSection& spool);
void declare(config::Visitor& v, LineSection& line);
void declare(config::Visitor& v, DryFrictionSection& friction);
void declare(config::Visitor& v, SensorSection& sensors);

}  // namespace farrier::robot
