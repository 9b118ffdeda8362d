#pragma once

#include <cstdint>

#include "core/time.hpp"

namespace farrier {

/// Without sign: an earlier tick is one from far ahead, and ticks at both ends of 64 bits do not overflow.
inline std::uint64_t ticks_since(Tick last, Tick now) noexcept {
  return static_cast<std::uint64_t>(now) - static_cast<std::uint64_t>(last);
}

}  // namespace farrier
