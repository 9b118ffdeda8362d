#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"
#include "tools/report/figures.hpp"
#include "tools/report/run_info.hpp"

namespace farrier::report {

/// What a command that measures ends with.
struct Outcome {
  std::string command;  ///< "trot", "bench", ...
  Figures figures;
  RunInfo run;
  std::vector<std::string> failures;  ///< what went wrong besides figures: "joint_node_lf ended with status 1"
  std::vector<std::string> warnings = {};  ///< what went wrong and fails nothing

  /// Every figure holds and nothing else failed.
  bool passes() const noexcept { return failures.empty() && figures.all_hold(); }
};

/// {"command", "verdict": "pass"|"fail", "failures", "warnings" (only when there are any), "figures": [{"name", "value", "unit"},
/// with a bound also "relation", "bound", "holds"], "run": {...}}. Values that are not finite are null.
std::string to_json(const Outcome& outcome);

/// Writes to_json() to `path`; refuses what the disk does not take.
Result<Done> write_json(const std::string& path, const Outcome& outcome);

}  // namespace farrier::report
