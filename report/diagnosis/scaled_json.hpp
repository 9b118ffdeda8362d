#pragma once

#include <string>

#include "core/result.hpp"
#include "report/figures/outcome.hpp"
#include "report/diagnosis/scaled_result.hpp"

namespace farrier::report {

/// The form of diagnosis_json() with "units": "scaled", for the keys that a recording without a joint has: "robot",
/// "joint", "experiment", "control" and "extended_model" are null, "channels" and "experiments" empty. Beside them
/// "model": {"gain_before", "drift_before", "gain_after", "drift_after"} per sample, of the fits to the first half, or
/// null; and "candidates": [{"name", "parameter", "value", "unit", "fit_percent", "accepted"}], each effect alone.
std::string scaled_json(const ScaledResult& result, const Outcome& outcome);

/// Writes it to `path`; refuses what the disk does not take.
Result<Done> write_scaled_json(const std::string& path, const ScaledResult& result, const Outcome& outcome);

}  // namespace farrier::report
