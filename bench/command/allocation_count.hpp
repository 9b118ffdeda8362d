#pragma once

#include <cstdint>

namespace farrier::cli {

/// Calls of operator new that this thread has made. The farrier command counts them for its benchmarks.
std::int64_t allocation_count();

}  // namespace farrier::cli
