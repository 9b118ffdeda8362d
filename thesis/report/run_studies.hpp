#pragma once

#include <functional>
#include <span>
#include <vector>

#include "thesis/report/claims.hpp"

namespace farrier::thesis {

/// Told the share of all studies done, [0, 1], by one thread at a time; false: stop.
using Progress = std::function<bool(double)>;

/// Runs the studies on `threads` >= 1 threads and returns them in their order. Studies that were never begun because of
/// a stop hold thesis::stopped(), as those that were interrupted do; one that throws a std::exception holds what it says.
std::vector<StudyRun> run_studies(std::span<const thesis::Study> studies, const thesis::StudyContext& context,
                                  int threads, const Progress& progress);

}  // namespace farrier::thesis
