#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"

namespace farrier::report {

/// Pictures of one joint, paths relative to the report; empty for what the run was too short for.
struct JointPictures {
  std::string tracking;  ///< reference and force, error below, planned stances shaded; three strides
  std::string overview;  ///< reference and error over the whole run
  std::string poles;     ///< closed loops against the unit circle
  std::string adaptation = {};  ///< gains over time, poles of the estimates; empty where nothing was decided
};

struct ReportInput;

/// Draws every joint's pictures below `out_dir` with one gnuplot process; its script and data stay in out_dir/data.
/// Refuses when gnuplot is missing or fails, the disk does not take the files, or a controller cannot be designed.
Result<std::vector<JointPictures>> draw_pictures(const std::string& out_dir, const ReportInput& input);

}  // namespace farrier::report
