#pragma once

#include <string>

namespace farrier::runtime {

/// Makes the calling thread real-time: SCHED_FIFO at `priority`, memory locked, stack touched. Where the system's
/// limits forbid a step the thread runs on without it; returns what could not be had, empty when all could.
std::string make_realtime(int priority);

}  // namespace farrier::runtime
