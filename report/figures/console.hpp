#pragma once

#include <string>

#include "report/figures/outcome.hpp"

namespace farrier::report {

/// True where escape sequences are welcome: the descriptor is a terminal and the environment has no NO_COLOR.
bool wants_colour(int file_descriptor);

/// The outcome for people, about 100 columns wide: a table of joints with "!" where a bound fails, other figures,
/// processes with their samples, latency, why it fails, and the verdict as the last line.
std::string console_text(const Outcome& outcome, bool colour);

/// The end of it alone, for a command with a table of its own: warnings, why it fails, the verdict.
std::string verdict_text(const Outcome& outcome, bool colour);

}  // namespace farrier::report
