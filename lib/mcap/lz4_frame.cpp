#include "mcap/lz4_frame.hpp"

#include <algorithm>

#include "mcap/bytes.hpp"

namespace farrier::mcap {
namespace {

using Out = std::vector<std::uint8_t>;

constexpr std::uint32_t kFrame = 0x184d2204;
constexpr std::uint32_t kSkippable = 0x184d2a50, kSkippableMask = 0xfffffff0;
constexpr std::uint32_t kStoredBlock = 0x80000000;
constexpr std::size_t kShortestMatch = 4;

/// Bits of a frame's first byte.
enum FrameBit : std::uint8_t {
  kDictionary = 0x01,
  kContentChecksum = 0x04,
  kContentSize = 0x08,
  kBlockChecksum = 0x10,
  kIndependentBlocks = 0x20
};

/// A length of four bits, and further bytes as long as they are 255.
std::size_t read_length(std::size_t four_bits, ByteReader& in) {
  std::size_t length = four_bits;
  for (bool more = four_bits == 15; more && in.good();) {
    const auto next = in.number<std::uint8_t>();
    length += next;
    more = next == 255;
  }
  return length;
}

/// Appends a block's bytes. Matches may reach back to `first` in `out`.
bool expand_block(std::span<const std::uint8_t> block, std::size_t first, std::size_t size, Out& out) {
  ByteReader in(block);
  while (true) {
    const auto token = in.number<std::uint8_t>();
    const auto literals = in.bytes(read_length(token >> 4, in));
    if (!in.good() || literals.size() > size - out.size()) {
      return false;
    }
    out.insert(out.end(), literals.begin(), literals.end());
    if (in.rest().empty()) {
      return true;  // the last sequence has no match
    }
    const std::size_t back = in.number<std::uint16_t>();
    const std::size_t length = kShortestMatch + read_length(token & 15, in);
    if (!in.good() || back == 0 || back > out.size() - first || length > size - out.size()) {
      return false;
    }
    for (std::size_t i = 0; i < length; ++i) {
      out.push_back(out[out.size() - back]);  // it may overlap what it appends
    }
  }
}

bool expand_frame(ByteReader& in, std::size_t size, Out& out) {
  const auto bits = in.number<std::uint8_t>();
  in.number<std::uint8_t>();  // largest block
  in.bytes((bits & kContentSize) != 0 ? sizeof(std::uint64_t) : 0);
  in.number<std::uint8_t>();  // checksum of these
  const std::size_t begin = out.size();
  while (in.good() && (bits & kDictionary) == 0) {
    const auto head = in.number<std::uint32_t>();
    if (head == 0) {
      in.bytes((bits & kContentChecksum) != 0 ? sizeof(std::uint32_t) : 0);
      return in.good();
    }
    const auto block = in.bytes(head & ~kStoredBlock);
    in.bytes((bits & kBlockChecksum) != 0 ? sizeof(std::uint32_t) : 0);
    if ((head & kStoredBlock) != 0 && block.size() <= size - out.size()) {
      out.insert(out.end(), block.begin(), block.end());
    } else if ((head & kStoredBlock) != 0 ||
               !expand_block(block, (bits & kIndependentBlocks) != 0 ? out.size() : begin, size, out)) {
      return false;
    }
  }
  return false;
}

}  // namespace

std::optional<Out> expand_lz4_frames(std::span<const std::uint8_t> data, std::size_t size) {
  Out out;
  for (ByteReader in(data); !in.rest().empty();) {
    const auto magic = in.number<std::uint32_t>();
    if ((magic & kSkippableMask) == kSkippable) {
      in.bytes(in.number<std::uint32_t>());
    } else if (magic != kFrame || !expand_frame(in, size, out)) {
      return std::nullopt;
    }
    if (!in.good()) {
      return std::nullopt;
    }
  }
  return out;
}

}  // namespace farrier::mcap
