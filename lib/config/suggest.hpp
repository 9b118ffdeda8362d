#pragma once

#include <string>
#include <vector>

namespace farrier::config {

/// The unit a parameter's name ends with ("Pa" of "supply_pressure_Pa", "Ns_m" of "damping_Ns_m"); empty for none.
std::string unit_of(const std::string& name);

/// The name that an unknown name was probably meant to be.
struct Suggestion {
  std::string name;  ///< a known name; empty when none is near
  std::string unit;  ///< not empty when the stem is right and only the unit is not
};

/// A known name with the same stem and another unit, otherwise the nearest by edit distance (Levenshtein 1966),
/// at most a third of its length away.
Suggestion suggest(const std::string& unknown, const std::vector<std::string>& known);

}  // namespace farrier::config
