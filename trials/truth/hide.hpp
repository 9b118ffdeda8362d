#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/noise.hpp"
#include "trials/truth/machine.hpp"

namespace farrier::truth {

/// Reference values of the sizes of effects; the motion is that of the same plan without effect.
struct Extents {
  double push;             ///< area_a times half the supply, N or Nm
  double length;           ///< 1 for a stroke of 80 mm: unit of lengths and speeds
  double period_s, duration_s;
  double peak_current_A;
  double peak_flow_m3_s;   ///< drawn from the supply
  double excursion;        ///< largest, from mid-stroke
  double stretch;          ///< largest of the load spring
  double rms_force;        ///< at the load cell, about its mean
  double rms_motion;       ///< position, about its mean
};

/// Draws of one effect: the same for it whatever else is hidden.
class Chance {
 public:
  Chance(std::uint64_t seed, const std::string& joint, const std::string& effect)
      : stream_(seed, joint, "truth effect " + effect) {}
  double sign() const { return stream_.uniform(0) < 0.5 ? -1.0 : 1.0; }
  double spread() const { return 0.85 + 0.3 * stream_.uniform(1); }
  double within(double low, double high) const { return low + (high - low) * stream_.uniform(2); }

 private:
  NoiseStream stream_;
};

/// One effect: three sizes, and what a size does to a machine.
struct Entry {
  const char* name;
  const char* headline;  ///< its parameter; N, N/m and the like are Nm, Nm/rad for a rotary joint
  double sizes[3];       ///< in the unit that `hide` wants
  /// Puts the effect into the machine and gives its headline parameter.
  double (*hide)(Machine&, double size, const Extents&, const Chance&);
};

/// Null for an unknown name.
const Entry* find_entry(const std::string& name);

/// Names in the order of the table.
std::vector<std::string> names_of(bool outside);

}  // namespace farrier::truth
