#pragma once

#include <string>

#include "report/walk/walk_run.hpp"

namespace farrier::report {

/// A stretch of the run, and the room for it in a picture.
struct StripFrame {
  double from_s, loop_s;
  double left_px, right_px, top_px, bottom_px;
};

/// Strips of a moving SVG with a line that runs through them once per loop: pressure and flows of the supply, chamber
/// pressures and valve current of the last joint of the first leg. The run has a supply.
std::string moving_strips(const WalkRun& run, const StripFrame& frame);

}  // namespace farrier::report
