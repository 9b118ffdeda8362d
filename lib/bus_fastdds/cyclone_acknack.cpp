#include "bus_fastdds/cyclone_acknack.hpp"

#include "bus_fastdds/rtps_datagram.hpp"

namespace farrier::bus_fastdds {
namespace {

using namespace rtps_datagram;

// RTPS 2.2, 9.4.5.2: reader id, writer id, base (high, low), number of bits, bitmap, count.
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

void translate(const Submessage& acknack) noexcept {
  const std::span<std::uint8_t> body = acknack.body;
  if (body.size() < kBitmapOffset) {
    return;
  }
  const std::uint32_t bits = Word(&body[kBitCountOffset], acknack.little_endian()).get();
  const std::size_t count_offset = kBitmapOffset + (bits + 31) / 32 * 4;
  if (bits > 256 || body.size() < count_offset + 4) {
    return;
  }
  Word base(&body[kBaseLowOffset], acknack.little_endian());
  Word count(&body[count_offset], acknack.little_endian());
  const bool greeting = bits == 0 && (acknack.flags & kFinalFlag) == 0 && count.get() == 0;
  if (greeting && base.get() == 1) {
    base.set(0);
  }
  count.set(count.get() + 1);
}

}  // namespace

bool translate_cyclone_acknacks(std::span<std::uint8_t> datagram) noexcept {
  bool secured = false;
  if (!is_from_cyclone(datagram)) {
    return secured;
  }
  for_each_submessage(datagram, [&](const Submessage& submessage) {
    if (submessage.kind == kAcknack) {
      translate(submessage);
    }
    secured = submessage.kind == kSecurePrefix || submessage.kind == kSecureRtpsPrefix;
    return !secured;
  });
  return secured;
}

}  // namespace farrier::bus_fastdds
