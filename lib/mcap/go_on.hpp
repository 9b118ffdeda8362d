#pragma once

#include <cstddef>
#include <functional>

namespace farrier::mcap {

/// Asked every few megabytes of a chunk; the work ends where the answer is false.
using GoOn = std::function<bool()>;

/// Bytes of a chunk between two questions. A false size costs no more memory than what has come and a piece.
inline constexpr std::size_t kPieceBytes = 1u << 22;

}  // namespace farrier::mcap
