#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"

namespace farrier::report {

/// Pictures of one joint, paths relative to the report; empty for what the run was too short for.
struct JointPictures {
  std::string tracking;        ///< reference and force, error below, planned stances shaded; three strides
  std::string overview;        ///< reference and error over the whole run
  std::string poles;           ///< closed loops against the unit circle
  std::string gains = {};      ///< of both slots over time; empty where nothing was decided
  std::string estimates = {};  ///< their poles; likewise
};

struct ReportInput;

/// Draws every joint's pictures. Refuses as Drawing::draw does, and a joint for which no controller can be designed.
Result<std::vector<JointPictures>> draw_pictures(const std::string& out_dir, const ReportInput& input);

}  // namespace farrier::report
