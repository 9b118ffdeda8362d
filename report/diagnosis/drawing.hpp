#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"
#include "diagnosis/judge/judgement.hpp"

namespace farrier::report {

/// One line of a data file; gnuplot leaves out values that are no numbers.
std::string line_of(const std::vector<double>& values);

/// True if a line can be drawn through values: two of them are finite.
bool has_points(const std::vector<double>& values);

/// Pictures of one report as they are made ready for gnuplot.
struct Drawing {
  std::string out_dir;
  std::string script = {};
  Result<Done> kept = Done{};  ///< the first refusal

  /// Data for the script, by a path that it may name.
  std::string data(const std::string& name, const std::string& lines);
};

/// Draws the gain of each candidate in a round of the selection, counted from 0; returns the picture's path in the
/// report.
std::string round_picture(Drawing& drawing, std::vector<diagnosis::Candidate> candidates, std::size_t round);

}  // namespace farrier::report
