#pragma once

#include <string>
#include <vector>

namespace farrier::config {

/// One mistake in a configuration: where it is and what to do about it.
struct Problem {
  std::string file;
  int line = 0;         ///< 1-based; 0 where no line applies (unreadable file, value from the command line)
  std::string where;    ///< dotted path of the parameter; empty for the file as a whole
  std::string message;  ///< what is wrong and the remedy

  friend bool operator==(const Problem&, const Problem&) = default;
};

using Problems = std::vector<Problem>;

/// "hyq.yaml:41: loads.bench.stance.mass_kg: -3 is out of range: give 0.01 to 1000"
std::string to_string(const Problem& problem);

/// One line per problem, in the order of the file.
std::string to_string(const Problems& problems);

/// Puts the problems in the order of their lines; those without a line come first.
void sort_by_line(Problems& problems);

}  // namespace farrier::config
