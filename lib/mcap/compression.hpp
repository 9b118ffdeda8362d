#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "mcap/go_on.hpp"

namespace farrier::mcap {

/// CRC-32 of zip and Ethernet (zlib), going on from `before`; 0 of nothing.
std::uint32_t crc32(std::span<const std::uint8_t> data, std::uint32_t before = 0) noexcept;

/// zstd at a fast level, with one context for all chunks of a file.
class Compressor {
 public:
  Compressor();
  ~Compressor();
  Compressor(Compressor&&) noexcept;
  Compressor& operator=(Compressor&&) noexcept;

  /// Valid until the next call.
  std::span<const std::uint8_t> compress(std::span<const std::uint8_t> data);

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

/// Decompresses a chunk. `compression`: "zstd" or "lz4", in any number of frames with or without their sizes; "" for
/// none. Refuses another compression, bytes that are not valid for it or have another size, and chunks of more than
/// kLargestChunk bytes, and when `go_on` returns false.
Result<std::vector<std::uint8_t>> decompress(
    std::vector<std::uint8_t> data, const std::string& compression, std::uint64_t uncompressed_size,
    const GoOn& go_on = [] { return true; });

/// No known recorder makes larger ones; a file that claims one is broken.
inline constexpr std::uint64_t kLargestChunk = 1u << 28;

}  // namespace farrier::mcap
