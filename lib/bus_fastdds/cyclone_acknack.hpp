#pragma once

#include <cstdint>
#include <span>

namespace farrier::bus_fastdds {

/// Rewrites, in a received RTPS datagram, the ACKNACKs of Cyclone DDS so that Fast DDS 2.9 answers the first one at
/// once instead of a second later. Datagrams of others, and malformed ones, stay as they are; so does what is signed or
/// encrypted by DDS Security, where Fast DDS answers a second later.
///
/// A reader greets a writer it has just discovered with an ACKNACK that acknowledges nothing; the writer's heartbeat is
/// then its starting point. Cyclone gives the greeting base 1, as RTPS wants, and count 0. Fast DDS knows a greeting by
/// base 0, which is its own dialect, and takes count 0 for a repetition. Its endpoint announcements then wait for their
/// next heartbeat, which has a fixed period of one second. A process that starts beside one of the other vendor would
/// receive nothing from it for so long. Here a greeting gets base 0, and every count is raised by one. Returns true if
/// it ends at something signed or encrypted.
bool translate_cyclone_acknacks(std::span<std::uint8_t> datagram) noexcept;

}  // namespace farrier::bus_fastdds
