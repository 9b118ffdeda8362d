#include "config/suggest.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace farrier::config {
namespace {

// Words a unit is made of, joined by "_" where the unit has a denominator or a product. Known units are SI; the
// others are here to be recognised and refused by name.
constexpr std::array kUnitWords = {"m",   "m2",  "m3",  "rad3", "mm",      "cm",   "um",  "inch", "s",    "s2",  "ms",
                                   "us",  "Hz",  "kHz", "rad",  "deg",     "rpm",  "kg",  "m2",   "g",    "t",   "lb",
                                   "N",   "kN",  "Nm",  "Ns",   "Nms",     "Pa",   "kPa", "MPa",  "GPa",  "bar", "psi",
                                   "A",   "mA",  "V",   "J",    "W",       "l",    "L",   "lpm",  "sqrt", "cm3", "cm2",
                                   "mm2", "mm3", "Ohm", "H",    "AsqrtPa", "rtHz", "1"};

bool is_unit_word(std::string_view word) {
  return std::find(kUnitWords.begin(), kUnitWords.end(), word) != kUnitWords.end();
}

// Length of the name without the unit words at its end; the first word never counts as a unit.
std::size_t stem_length(const std::string& name) {
  std::size_t end = name.size();
  for (;;) {
    const std::size_t cut = end == 0 ? std::string::npos : name.rfind('_', end - 1);
    if (cut == std::string::npos || cut == 0 || !is_unit_word(std::string_view(name).substr(cut + 1, end - cut - 1))) {
      return end;
    }
    end = cut;
  }
}

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) {
    row[j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitution = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitution});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string unit_of(const std::string& name) {
  const std::size_t stem = stem_length(name);
  return stem == name.size() ? "" : name.substr(stem + 1);
}

Suggestion suggest(const std::string& unknown, const std::vector<std::string>& known) {
  constexpr std::size_t kLongestName = 80;  // beyond it a name is garbage, and the distance not worth its time
  if (unknown.size() > kLongestName) {
    return {};
  }
  const std::string stem = unknown.substr(0, stem_length(unknown));
  for (const std::string& name : known) {
    if (const std::string unit = unit_of(name); !unit.empty() && name.substr(0, stem_length(name)) == stem) {
      return {name, unit};
    }
  }
  Suggestion nearest;
  std::size_t least = kLongestName;
  for (const std::string& name : known) {
    const std::size_t distance = edit_distance(unknown, name);
    if (distance < least && 3 * distance <= std::max(name.size(), std::size_t{3})) {
      least = distance;
      nearest.name = name;
    }
  }
  return nearest;
}

}  // namespace farrier::config
