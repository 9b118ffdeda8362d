#pragma once

#include <cstdint>

#include "core/time.hpp"

namespace farrier::runtime {

struct Deadline {
  SteadyTime next;        ///< when to wake
  std::uint64_t missed;   ///< whole periods that passed without a wake-up since `previous`
};

/// The next absolute deadline on the grid previous + n * period that lies after `now`. Late loops skip whole
/// periods and count them; they never catch up in a burst.
Deadline next_deadline(SteadyTime previous, SteadyTime now, Nanoseconds period) noexcept;

/// Sleeps until an absolute time of the steady clock (clock_nanosleep, TIMER_ABSTIME).
void sleep_until(SteadyTime time) noexcept;

}  // namespace farrier::runtime
