#pragma once

// Measures of how far confidences and intervals of blind trials hold, and the map that they are fitted by.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/confidence/confidence.hpp"
#include "trials/blind/blind_trials.hpp"

namespace farrier::blind {

/// One name with its confidence, and whether such an effect was hidden.
struct Statement {
  double confidence;
  bool right;
};

/// Every name of every trial.
std::vector<Statement> statements_of(const std::vector<Outcome>& outcomes);

/// Figures of forecasts; those of no statement are not numbers.
struct Calibration {
  std::size_t statements = 0;
  double brier = 0.0;            ///< mean square of confidence less 0 or 1 (Brier 1950)
  double spiegelhalter_z = 0.0;  ///< of standard normal distribution if every confidence is true (Spiegelhalter 1986)
  double error = 0.0;     ///< mean over statements of |mean confidence - share right| of their tenth, by confidence
  double expected = 0.0;  ///< the mean error if every confidence is true
  double most = 0.0;      ///< the largest confidence
};
Calibration calibration_of(std::vector<Statement> statements);

/// Share of the hidden sizes inside the 95 % interval of their name, with the 95 % band of that share (Wilson 1927).
struct Coverage {
  std::size_t sizes = 0;
  double share = 0.0, low = 0.0, high = 0.0;
};
Coverage coverage_of(const std::vector<Outcome>& outcomes);

/// The map that these trials give: the likeliest of non-negative weights, with a ridge of one statement for each weight.
/// Empty if they have no wrong name or no right one.
std::optional<diagnosis::ConfidenceMap> fitted_map(const std::vector<Outcome>& outcomes);

/// The map as lib/diagnosis/confidence/confidence_*.def has it, after a comment with its source.
std::string map_text(const diagnosis::ConfidenceMap& map, const std::string& source);

}  // namespace farrier::blind
