#include "robot/sections/variation_section.hpp"

#include <string>

namespace farrier::robot {
namespace {

using config::kInitial;
using config::Visitor;

std::string interval_text(const Interval& interval) {
  return "[" + config::number_text(interval.low) + ", " + config::number_text(interval.high) + "]";
}

/// A list of two numbers, lower end first; absent: what `interval` is by itself.
void declare_interval(Visitor& v, const char* name, Interval& interval, config::Range range, const char* meaning) {
  const std::string sentence = std::string(meaning) + " Two numbers, " + interval_text(interval) + " where absent.";
  std::vector<double> ends{interval.low, interval.high};
  v.numbers(name, ends, range, sentence.c_str());
  v.check(ends.empty() || (ends.size() == 2 && ends[0] <= ends[1]), name,
          "is no interval: give two numbers, the lower one first");
  if (ends.size() == 2) {
    interval = {ends[0], ends[1]};
  }
}

}  // namespace

void declare(Visitor& v, VariationSection& section) {
  Variation& d = section.params;
  v.here(section.place);
  v.number("body_mass_kg", d.body_mass_kg, {0, 1e4}, kInitial,
           "Mass of the whole robot, trunk and legs, in every draw; 0 is what the body section adds up to.");
  declare_interval(v, "stance_mass_kg", d.stance_mass_kg, {0.01, 1000},
                   "Stance load of a cylinder whose load grows in stance, each joint its own.");
  declare_interval(v, "supply_factor", d.supply_factor, {0.01, 100}, "On the supply pressure of the whole robot.");
  declare_interval(v, "friction_factor", d.friction_factor, {0, 100},
                   "On the damping of a joint's load in swing and stance.");
  declare_interval(v, "valve_gain_factor", d.valve_gain_factor, {0.01, 100}, "On the gain of a joint's valve.");
}

}  // namespace farrier::robot
