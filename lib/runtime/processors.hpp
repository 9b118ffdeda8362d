#pragma once

#include <vector>

namespace farrier::runtime {

/// Processors that the calling thread may run on, in ascending order.
std::vector<int> own_processors();

/// Keeps the calling thread, and what it starts, on one processor. Does nothing where there is no such one.
void stay_on(int processor) noexcept;

}  // namespace farrier::runtime
