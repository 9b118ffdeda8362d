#pragma once

#include <span>

#include "core/time.hpp"
#include "trace/trace.hpp"

namespace farrier::trace {

/// A sudden change of load: what comes before this is its transient.
inline constexpr double kJudgedAfter_s = 0.2;

/// RMS of reference less force over RMS of the reference over ticks [from, to); NaN without rows or reference.
double relative_error(std::span<const TraceRow> rows, Tick from, Tick to) noexcept;

}  // namespace farrier::trace
