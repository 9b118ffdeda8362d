#pragma once

#include <functional>
#include <span>
#include <vector>

#include "thesis/report/claims.hpp"

namespace farrier::thesis {

/// Told the share of all studies done, [0, 1], by one thread at a time; false: stop.
using Progress = std::function<bool(double)>;

/// Runs the studies with every one of `seeds` on `threads` >= 1 threads and returns them in their order. A study whose
/// results for the first two seeds are equal to the last bit draws nothing, and is not run with the others. Pictures are
/// kept for the first seed. Runs that were never begun because of a stop hold thesis::stopped(), as those that were
/// interrupted do; one that throws a std::exception holds its text. `seeds` is not empty; context.seed is not read.
std::vector<StudyRun> run_studies(std::span<const thesis::Study> studies, const thesis::StudyContext& context,
                                  std::span<const std::uint64_t> seeds, int threads, const Progress& progress);

}  // namespace farrier::thesis
