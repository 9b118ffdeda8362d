#pragma once

#include <chrono>
#include <cstdint>

namespace farrier {

/// Number of a control period since the run began; tick k covers [k T, (k + 1) T).
using Tick = std::int64_t;

/// "No tick yet": the invalid value of every tick field on the wire.
inline constexpr Tick kNoTick = -1;

/// Time of the receiver's steady clock. Never compared between computers.
using SteadyTime = std::chrono::steady_clock::time_point;

using Nanoseconds = std::chrono::nanoseconds;

}  // namespace farrier
