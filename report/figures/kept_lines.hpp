#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/result.hpp"

namespace farrier::report {

// Lines of JSON that a long command keeps as they come, so that an interrupted run can go on. Each line has the origin of
// its measurement: the build, robot and options that it depends on.

/// Appends `line` with its origin, on a line of its own also after one that was cut off. Refuses a file that cannot be
/// written.
Result<Done> append_kept(const std::string& path, const nlohmann::json& origin, nlohmann::json line);

/// Returns the lines of this origin, none where there is no file. A line that was cut off is passed over.
std::vector<nlohmann::json> read_kept(const std::string& path, const nlohmann::json& origin);

}  // namespace farrier::report
