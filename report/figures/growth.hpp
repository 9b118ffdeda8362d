#pragma once

#include <string>
#include <vector>

#include "report/figures/figures.hpp"

namespace farrier::report {

struct ProcessInfo;

/// By how much more of its computer a process holds at a run's end than after its first tenth.
struct Growth {
  double memory_KiB = 0;  ///< resident
  double threads = 0;
  double descriptors = 0;
};

// No process may grow. The kernel counts resident pages by processor and by dozens: what is below this is no growth.
inline constexpr double kMemoryGrowth_KiB = 2048;

/// Adds trot.memory_growth_KiB, trot.threads_growth and trot.descriptors_growth, each the largest over the processes,
/// with their bounds; returns a sentence for each that does not hold, with the process. No process was watched to the
/// end: not a number, which holds no bound.
std::vector<std::string> add_growth(Figures& figures, const std::vector<ProcessInfo>& processes);

}  // namespace farrier::report
