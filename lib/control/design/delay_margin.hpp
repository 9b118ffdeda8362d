#pragma once

#include "control/design/loop_response.hpp"

namespace farrier::control {

// Additional delays, in ticks, that make a loop unstable. The current is held between ticks: a delay by whole ticks is a
// pure one, a delay by part of one also changes the size of L.

/// Delay near a crossing of |L| = 1 at `angle` where a pure delay would be `ticks`: between the whole ones next to that.
double held_delay(const Loop& loop, double angle, double ticks) noexcept;

/// Least delay, part of a tick, at which the loop is at -1 at half the sampling rate, where it is real; infinite for
/// none. The search looks at every eighth of a tick.
double turning_delay(const Loop& loop) noexcept;

/// Smallest delay behind filters. The search is about `estimate`, that of the crossings, while it is a few ticks: within
/// a tick a held current can make a loop unstable whose |L| crosses 1 nowhere near.
double delay_behind_filters(const Loop& loop, double estimate) noexcept;

}  // namespace farrier::control
