#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"
#include "trials/body/trot_trial.hpp"

namespace farrier::report {

// Runs that ended, a line of JSON each, so that an interrupted trial goes on.

/// Appends a run. `origin` is what the runs depend on: the build and the robot. Refuses a file that cannot be written.
Result<Done> append_row(const std::string& path, const std::string& origin, const trials::TrotRow& row);

/// Runs of this origin; none where there is no file. Passes over a line that was cut off.
std::vector<trials::TrotRow> read_rows(const std::string& path, const std::string& origin);

}  // namespace farrier::report
