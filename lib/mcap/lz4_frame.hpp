#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace farrier::mcap {

/// Expands LZ4 frames (LZ4 Frame Format 1.6.4, LZ4 Block Format, by Y. Collet), skippable ones among them, to at most
/// `size` bytes. Checksums of frames are not checked: a chunk has its own. Empty for bytes that are no whole frames,
/// need a dictionary or give more.
std::optional<std::vector<std::uint8_t>> expand_lz4_frames(std::span<const std::uint8_t> data, std::size_t size);

}  // namespace farrier::mcap
