#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace farrier::bus_fastdds {

/// A received RTPS datagram without its secured submessages, when Cyclone DDS put a message of the handshake of DDS
/// Security behind one; else nothing. Malformed datagrams give nothing.
///
/// Cyclone sends what it has for a peer in one datagram. Once the handshake is over on its side that may be an encrypted
/// ACKNACK followed by the message that ends the handshake for Fast DDS. Fast DDS 2.9 has no key yet, drops the
/// ACKNACK and with it the rest of the datagram, and repeats its last message for ever; Cyclone has forgotten the
/// handshake by then. Given this first, and the datagram itself afterwards, Fast DDS has the key in time for both.
std::vector<std::uint8_t> handshake_without_secured(std::span<std::uint8_t> datagram);

}  // namespace farrier::bus_fastdds
