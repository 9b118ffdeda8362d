#pragma once

// RTPS messages, byte by byte (OMG DDSI-RTPS 2.3, section 9.4.5).

#include <cstdint>
#include <vector>

namespace farrier::bus_fastdds::testing {

using Bytes = std::vector<std::uint8_t>;

inline constexpr std::uint8_t kFastDds = 0x0f;
inline constexpr std::uint8_t kCyclone = 0x10;

inline constexpr std::uint8_t kInfoTimestamp = 0x09;
inline constexpr std::uint8_t kInfoDestination = 0x0e;
inline constexpr std::uint8_t kData = 0x15;

/// The first bytes of a message of a vendor's participant.
inline Bytes header(std::uint8_t vendor = kFastDds, std::uint8_t participant = 1) {
  return {'R', 'T', 'P', 'S', 2, 1, 1, vendor, 0, 0, 0, 0, 0, 0, 0, participant, 0, 0, 0, 0};
}

/// A little-endian submessage with a body of equal bytes.
inline Bytes submessage(std::uint8_t kind, std::uint8_t body_bytes = 8, std::uint8_t filling = 0) {
  Bytes bytes{kind, 1, body_bytes, 0};
  bytes.insert(bytes.end(), body_bytes, filling);
  return bytes;
}

inline Bytes joined(const std::vector<Bytes>& parts) {
  Bytes all;
  for (const Bytes& part : parts) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

inline Bytes datagram(std::uint8_t vendor, const std::vector<Bytes>& submessages) {
  return joined({header(vendor), joined(submessages)});
}

}  // namespace farrier::bus_fastdds::testing
