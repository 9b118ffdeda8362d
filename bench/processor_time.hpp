#pragma once

#include <ctime>

namespace farrier::bench {

/// Processor time of this thread since its start, s.
inline double processor_s() noexcept {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace farrier::bench
