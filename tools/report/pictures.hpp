#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "gait/schedule.hpp"
#include "record/trace.hpp"
#include "robot/robot.hpp"

namespace farrier::report {

/// Pictures of one joint, paths relative to the report; empty for what the run was too short for.
struct JointPictures {
  std::string tracking;  ///< reference and force, error below, planned stances shaded; three strides
  std::string overview;  ///< reference and error over the whole run
  std::string poles;     ///< closed loops against the unit circle
};

/// Draws every joint's pictures below `out_dir` with one gnuplot process; its script and data stay in out_dir/data.
/// Refuses when gnuplot is missing or fails, the disk does not take the files, or a controller cannot be designed.
Result<std::vector<JointPictures>> draw_pictures(const std::string& out_dir, const robot::Robot& robot,
                                                 const gait::Schedule& schedule,
                                                 std::span<const record::TraceRow> rows, int loop_delay_ticks);

}  // namespace farrier::report
