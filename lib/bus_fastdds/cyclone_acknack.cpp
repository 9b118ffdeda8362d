#include "bus_fastdds/cyclone_acknack.hpp"

#include <array>
#include <cstring>

namespace farrier::bus_fastdds {
namespace {

// RTPS 2.2, 9.4.1: message header ("RTPS", version, vendor, GUID prefix), then submessages with headers of their own.
constexpr std::size_t kHeaderBytes = 20;
constexpr std::array<std::uint8_t, 4> kProtocol{'R', 'T', 'P', 'S'};
constexpr std::size_t kVendorOffset = 6;
constexpr std::array<std::uint8_t, 2> kCyclone{0x01, 0x10};

constexpr std::size_t kSubmessageHeaderBytes = 4;
constexpr std::uint8_t kLittleEndianFlag = 0x01;

// DDS Security 1.1, 7.3.6: what follows either is signed, or holds nothing that can be read.
constexpr std::uint8_t kSecurePrefix = 0x31;
constexpr std::uint8_t kSecureRtpsPrefix = 0x33;

// 9.4.5.3: reader id, writer id, base (high, low), number of bits, bitmap, count.
constexpr std::uint8_t kAcknack = 0x06;
constexpr std::uint8_t kFinalFlag = 0x02;
constexpr std::size_t kBaseLowOffset = 12;
constexpr std::size_t kBitCountOffset = 16;
constexpr std::size_t kBitmapOffset = 20;

/// A number in the byte order of its submessage.
class Word {
 public:
  Word(std::uint8_t* bytes, bool little_endian) noexcept : bytes_(bytes), little_endian_(little_endian) {}

  std::uint32_t get() const noexcept {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) {
      value |= static_cast<std::uint32_t>(bytes_[i]) << shift(i);
    }
    return value;
  }
  void set(std::uint32_t value) noexcept {
    for (int i = 0; i < 4; ++i) {
      bytes_[i] = static_cast<std::uint8_t>(value >> shift(i));
    }
  }

 private:
  int shift(int byte) const noexcept { return 8 * (little_endian_ ? byte : 3 - byte); }

  std::uint8_t* bytes_;
  bool little_endian_;
};

void translate(std::span<std::uint8_t> body, std::uint8_t flags) noexcept {
  if (body.size() < kBitmapOffset) {
    return;
  }
  const bool little_endian = (flags & kLittleEndianFlag) != 0;
  const std::uint32_t bits = Word(&body[kBitCountOffset], little_endian).get();
  const std::size_t count_offset = kBitmapOffset + (bits + 31) / 32 * 4;
  if (bits > 256 || body.size() < count_offset + 4) {
    return;
  }
  Word base(&body[kBaseLowOffset], little_endian);
  Word count(&body[count_offset], little_endian);
  const bool greeting = bits == 0 && (flags & kFinalFlag) == 0 && count.get() == 0;
  if (greeting && base.get() == 1) {
    base.set(0);
  }
  count.set(count.get() + 1);
}

}  // namespace

void translate_cyclone_acknacks(std::span<std::uint8_t> datagram) noexcept {
  if (datagram.size() < kHeaderBytes || std::memcmp(datagram.data(), kProtocol.data(), kProtocol.size()) != 0 ||
      std::memcmp(&datagram[kVendorOffset], kCyclone.data(), kCyclone.size()) != 0) {
    return;
  }
  std::size_t at = kHeaderBytes;
  while (at + kSubmessageHeaderBytes <= datagram.size()) {
    const std::uint8_t kind = datagram[at];
    if (kind == kSecurePrefix || kind == kSecureRtpsPrefix) {
      return;
    }
    const std::uint8_t flags = datagram[at + 1];
    const bool little_endian = (flags & kLittleEndianFlag) != 0;
    std::size_t length = little_endian ? datagram[at + 2] + 256u * datagram[at + 3]
                                       : datagram[at + 3] + 256u * datagram[at + 2];
    at += kSubmessageHeaderBytes;
    if (length == 0 || length > datagram.size() - at) {  // 0: the rest of the datagram, always the last
      length = datagram.size() - at;
    }
    if (kind == kAcknack) {
      translate(datagram.subspan(at, length), flags);
    }
    at += length;
  }
}

}  // namespace farrier::bus_fastdds
