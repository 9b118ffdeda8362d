#pragma once

#include <string>
#include <vector>

#include "trials/truth/electric_machine.hpp"
#include "trials/truth/hide.hpp"

namespace farrier::truth::electric {

/// Reference values of the sizes of effects; the motion is that of the same plan without effect.
struct Extents {
  double rated_Nm, period_s, duration_s;
  double peak_A;      ///< largest command
  double excursion;   ///< largest, from mid-travel
  double rms_torque;  ///< at the sensor, about its mean
  double rms_motion;
};

/// One effect, as hide.hpp's Entry.
struct Entry {
  const char* name;
  const char* headline;
  bool of_spring, of_rigid;  ///< drives that have it
  double sizes[3];
  double (*hide)(ElectricMachine&, double size, const Extents&, const Chance&);
};

/// Null for an unknown name.
const Entry* find_entry(const std::string& name);

/// Names in the order of the table, of drives with a spring or rigid ones.
std::vector<std::string> names_of(bool outside, bool rigid);

}  // namespace farrier::truth::electric
