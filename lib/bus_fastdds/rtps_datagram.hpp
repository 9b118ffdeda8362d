#pragma once

// Parts of RTPS datagrams that are read before Fast DDS reads them: RTPS 2.2, 9.4.

#include <array>
#include <cstdint>
#include <cstring>
#include <span>

namespace farrier::bus_fastdds::rtps_datagram {

/// "RTPS", version, vendor, GUID prefix.
inline constexpr std::size_t kHeaderBytes = 20;
inline constexpr std::size_t kSubmessageHeaderBytes = 4;
inline constexpr std::uint8_t kLittleEndianFlag = 0x01;

enum Kind : std::uint8_t {
  kAcknack = 0x06,
  kInfoDestination = 0x0e,
  kData = 0x15,
  kDataFrag = 0x16,
  // DDS Security 1.1, 7.3.6: everything between prefix and postfix is signed or encrypted, and so is the whole datagram
  // behind the prefix of its own kind.
  kSecurePrefix = 0x31,
  kSecurePostfix = 0x32,
  kSecureRtpsPrefix = 0x33,
  // RTPS 2.2, 9.4.5.1.1: from here on each vendor's own, which others pass over.
  kFastStatistics = 0x80,  ///< at the end of every message of Fast DDS
};

struct Submessage {
  std::uint8_t kind;
  std::uint8_t flags;
  std::span<std::uint8_t> body;
  std::size_t begins;  ///< where its header is in the datagram
  std::size_t ends;

  bool little_endian() const noexcept { return (flags & kLittleEndianFlag) != 0; }
};

inline bool is_from_cyclone(std::span<const std::uint8_t> datagram) noexcept {
  constexpr std::array<std::uint8_t, 4> kProtocol{'R', 'T', 'P', 'S'};
  constexpr std::size_t kVendorOffset = 6;
  constexpr std::array<std::uint8_t, 2> kCyclone{0x01, 0x10};
  return datagram.size() >= kHeaderBytes && std::memcmp(datagram.data(), kProtocol.data(), kProtocol.size()) == 0 &&
         std::memcmp(&datagram[kVendorOffset], kCyclone.data(), kCyclone.size()) == 0;
}

/// Calls `visit(Submessage)` for each until it returns false. A submessage that is longer than the datagram ends with
/// it.
template <class Visitor>
void for_each_submessage(std::span<std::uint8_t> datagram, Visitor&& visit) {
  std::size_t at = kHeaderBytes;
  while (at + kSubmessageHeaderBytes <= datagram.size()) {
    const std::size_t begins = at;
    const std::uint8_t flags = datagram[at + 1];
    std::size_t length = (flags & kLittleEndianFlag) != 0 ? datagram[at + 2] + 256u * datagram[at + 3]
                                                          : datagram[at + 3] + 256u * datagram[at + 2];
    at += kSubmessageHeaderBytes;
    if (length == 0 || length > datagram.size() - at) {  // 0: the rest of the datagram, always the last
      length = datagram.size() - at;
    }
    const Submessage submessage{datagram[begins], flags, datagram.subspan(at, length), begins, at + length};
    at += length;
    if (!visit(submessage)) {
      return;
    }
  }
}

}  // namespace farrier::bus_fastdds::rtps_datagram
