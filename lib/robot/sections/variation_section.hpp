#pragma once

#include "config/visitor.hpp"

namespace farrier::robot {

/// Both ends belong to it; low <= high.
struct Interval {
  double low;
  double high;
};

/// Between what a varied robot (`farrier compare varied`) is drawn, every value uniformly.
struct Variation {
  double body_mass_kg = 0.0;                ///< of the whole robot, the same in every draw; 0: as the body section says
  Interval stance_mass_kg{10.0, 80.0};      ///< on a cylinder that carries the body, per joint
  Interval supply_factor{0.7, 1.3};         ///< on the supply pressure, per robot
  Interval friction_factor{1.0, 5.0};       ///< on the damping of a load, per joint
  Interval valve_gain_factor{0.8, 1.2};     ///< per joint
};

struct VariationSection {
  Variation params;
  config::Place place;
};

void declare(config::Visitor& v, VariationSection& variation);

}  // namespace farrier::robot
