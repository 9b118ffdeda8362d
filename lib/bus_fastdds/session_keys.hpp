#pragma once

#include <cstdint>

namespace farrier::bus_fastdds {

/// Makes each thread of this process derive the key of an encrypted session once, not for every message. The call links
/// the replacement of Fast DDS's function.
void remember_session_keys() noexcept;

/// Number of keys that Fast DDS has derived so far in this process.
std::uint64_t session_keys_derived() noexcept;

}  // namespace farrier::bus_fastdds
