#pragma once

// Script, rounds and clock of the benches of a walking robot.

#include <ctime>

#include "locomotion/motion_script.hpp"

namespace farrier::bench {

inline constexpr int kTicksOfARound = 500;
inline constexpr double kSettled_s = 10.0;  ///< the trot is steady from here on

/// Stands up and trots forward.
inline std::vector<locomotion::TimedCommand> benched_walk() {
  return locomotion::walk_script({.request = locomotion::Request::kTrot, .forward_m_s = 0.4});
}

/// Processor time of this thread since its start, s.
inline double processor_s() noexcept {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace farrier::bench
