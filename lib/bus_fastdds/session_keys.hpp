#pragma once

#include <cstdint>

namespace farrier::bus_fastdds {

/// A thread of this process derives the key of an encrypted session once, not for every message it hears.
/// Calling this links what does it.
void remember_session_keys() noexcept;

/// How many Fast DDS has derived so far in this process.
std::uint64_t session_keys_derived() noexcept;

}  // namespace farrier::bus_fastdds
