#pragma once

#include <cstdint>
#include <ctime>

#include "core/time.hpp"

namespace farrier::participant {

// The steady clock by which a process's control and its ages go. In slow motion it goes slower than the machine's, by the
// same factor in every process of a computer: everything happens as on a computer that is so much faster.

/// To be called once, before anything looks at the clock. `slow` >= 1.
void set_slow_motion(int slow) noexcept;
int slow_motion() noexcept;

SteadyTime steady_now() noexcept;

/// The date, as far as this computer knows it: for certificates, whose dates are in it.
std::time_t date_now() noexcept;

/// The same in nanoseconds since 1970: for files, whose samples are dated by it.
std::uint64_t date_now_ns() noexcept;

/// The machine's steady clock at that time.
SteadyTime machine_time(SteadyTime time) noexcept;

}  // namespace farrier::participant
