#include "mcap/compression.hpp"

#include <lz4frame.h>
#include <zlib.h>
#include <zstd.h>
#include <zstd_errors.h>

#include <algorithm>
#include <optional>

#include "core/ensure.hpp"

namespace farrier::mcap {
namespace {

constexpr int kLevel = -2;  // two thirds of the time of level 1, for chunks an eighth larger

/// Room for another piece. False if `out` already has more than `size` bytes, and when `go_on` returns false.
bool make_room(std::vector<std::uint8_t>& out, std::size_t size, const GoOn& go_on) {
  const std::size_t filled = out.size();
  if (filled > size || (filled > 0 && !go_on())) {
    return false;
  }
  out.resize(std::min(size + 1, filled + kPieceBytes));
  return true;
}

struct FreeDecompressor {
  void operator()(ZSTD_DCtx* context) const noexcept { ZSTD_freeDCtx(context); }
  void operator()(LZ4F_dctx* context) const noexcept { LZ4F_freeDecompressionContext(context); }
};

/// Expands zstd frames to at most `size` bytes. Empty for bytes that are no whole frames or give more, and when `go_on`
/// returns false. Bytes behind a frame that ends at `size` are left.
std::optional<std::vector<std::uint8_t>> expand_zstd(std::span<const std::uint8_t> data, std::size_t size,
                                                     const GoOn& go_on) {
  const std::unique_ptr<ZSTD_DCtx, FreeDecompressor> context(ZSTD_createDCtx());
  std::vector<std::uint8_t> out;
  out.reserve(size + 1);
  ZSTD_inBuffer in{data.data(), data.size(), 0};
  std::size_t filled = 0, left_of_frame = 0;
  while (in.pos < in.size || filled == out.size()) {
    if (filled == out.size() && !make_room(out, size, go_on)) {
      return std::nullopt;
    }
    ZSTD_outBuffer to{out.data(), out.size(), filled};
    const std::size_t left = ZSTD_decompressStream(context.get(), &to, &in);
    if (ZSTD_getErrorCode(left) == ZSTD_error_frameParameter_windowTooLarge) {
      out.resize(size);  // at once, no window is needed
      const std::size_t all = ZSTD_decompressDCtx(context.get(), out.data(), size, data.data(), data.size());
      return ZSTD_isError(all) == 0 && all == size ? std::optional(std::move(out)) : std::nullopt;
    }
    if (ZSTD_isError(left) != 0) {
      if (filled != size || left_of_frame != 0) {
        return std::nullopt;
      }
      break;
    }
    left_of_frame = left;
    filled = to.pos;
  }
  out.resize(filled);
  return left_of_frame == 0 ? std::optional(std::move(out)) : std::nullopt;
}

/// Expands LZ4 frames (LZ4 Frame Format 1.6.4, by Y. Collet), skippable ones among them, to at most `size` bytes. Empty for
/// bytes that are no whole frames, have a wrong checksum, need a dictionary or give more, and when `go_on` returns false.
std::optional<std::vector<std::uint8_t>> expand_lz4(std::span<const std::uint8_t> data, std::size_t size,
                                                    const GoOn& go_on) {
  LZ4F_dctx* made = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)) != 0) {
    return std::nullopt;
  }
  const std::unique_ptr<LZ4F_dctx, FreeDecompressor> context(made);
  std::vector<std::uint8_t> out;
  out.reserve(size + 1);
  std::size_t filled = 0, left_of_frame = 0;
  bool moves = true;
  while (moves && (!data.empty() || left_of_frame != 0)) {
    if (filled == out.size() && !make_room(out, size, go_on)) {
      return std::nullopt;
    }
    std::size_t written = out.size() - filled, read = data.size();
    left_of_frame = LZ4F_decompress(context.get(), out.data() + filled, &written, data.data(), &read, nullptr);
    if (LZ4F_isError(left_of_frame) != 0) {
      return std::nullopt;
    }
    filled += written;
    data = data.subspan(read);
    moves = written + read > 0;
  }
  out.resize(filled);
  return left_of_frame == 0 ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace

std::uint32_t crc32(std::span<const std::uint8_t> data, std::uint32_t before) noexcept {
  return static_cast<std::uint32_t>(::crc32_z(before, data.data(), data.size()));
}

struct Compressor::Context {
  ZSTD_CCtx* zstd = ZSTD_createCCtx();
  std::vector<std::uint8_t> out;
  ~Context() { ZSTD_freeCCtx(zstd); }
};

Compressor::Compressor() : context_(std::make_unique<Context>()) {}
Compressor::~Compressor() = default;
Compressor::Compressor(Compressor&&) noexcept = default;
Compressor& Compressor::operator=(Compressor&&) noexcept = default;

std::span<const std::uint8_t> Compressor::compress(std::span<const std::uint8_t> data) {
  std::vector<std::uint8_t>& out = context_->out;
  out.resize(std::max(out.size(), ZSTD_compressBound(data.size())));
  const std::size_t size = ZSTD_compressCCtx(context_->zstd, out.data(), out.size(), data.data(), data.size(), kLevel);
  FARRIER_ENSURE(ZSTD_isError(size) == 0, "zstd fails although it has the room it asked for");
  return std::span(out).first(size);
}

Result<std::vector<std::uint8_t>> decompress(std::vector<std::uint8_t> data, const std::string& compression,
                                             std::uint64_t uncompressed_size, const GoOn& go_on) {
  if (uncompressed_size > kLargestChunk) {
    return Error{"a chunk claims " + std::to_string(uncompressed_size) + " bytes"};
  }
  const auto size = static_cast<std::size_t>(uncompressed_size);
  std::optional<std::vector<std::uint8_t>> out;
  if (compression.empty()) {
    out = std::move(data);
  } else if (compression == "zstd") {
    out = expand_zstd(data, size, go_on);
  } else if (compression == "lz4") {
    out = expand_lz4(data, size, go_on);
  } else {
    return Error{"it is compressed with '" + compression + "'; Farrier reads zstd, lz4 and uncompressed chunks"};
  }
  if (!out || out->size() != size) {
    return Error{"its bytes are damaged"};
  }
  return std::move(*out);
}

}  // namespace farrier::mcap
