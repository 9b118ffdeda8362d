#pragma once

#include "report/compare/load_cycle.hpp"

namespace farrier::report {

/// Draws out_dir/pictures/<run>_force.svg (reference and force above, gains below) and <run>_poles.svg (a panel a
/// quarter) with one gnuplot process. Refuses when gnuplot is missing or fails, or the disk does not take the files.
Result<Done> draw_load_cycle(const std::string& out_dir, const LoadCyclePlan& plan,
                             std::span<const LoadCycleRun> runs);

}  // namespace farrier::report
