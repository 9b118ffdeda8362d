#include "mcap/compression.hpp"

#include <zlib.h>
#include <zstd.h>
#include <zstd_errors.h>

#include <algorithm>
#include <optional>

#include "core/ensure.hpp"
#include "mcap/lz4_frame.hpp"

namespace farrier::mcap {
namespace {

constexpr int kLevel = -2;  // two thirds of the time of level 1, for chunks an eighth larger

/// Room for a chunk before more of it has come: a false size costs no memory.
constexpr std::size_t kFirstBytes = 1u << 16;

struct FreeDecompressor {
  void operator()(ZSTD_DCtx* context) const noexcept { ZSTD_freeDCtx(context); }
};

/// Expands zstd frames to at most `size` bytes. Empty for bytes that are no whole frames or give more. Bytes behind a
/// frame that ends at `size` are left.
std::optional<std::vector<std::uint8_t>> expand_zstd(std::span<const std::uint8_t> data, std::size_t size) {
  const std::unique_ptr<ZSTD_DCtx, FreeDecompressor> context(ZSTD_createDCtx());
  std::vector<std::uint8_t> out(std::min(size + 1, std::max(kFirstBytes, 4 * data.size())));
  ZSTD_inBuffer in{data.data(), data.size(), 0};
  std::size_t filled = 0, left_of_frame = 0;
  while (in.pos < in.size || filled == out.size()) {
    if (filled == out.size()) {
      if (out.size() > size) {
        return std::nullopt;
      }
      out.resize(std::min(size + 1, 2 * out.size()));
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
                                             std::uint64_t uncompressed_size) {
  if (uncompressed_size > kLargestChunk) {
    return Error{"a chunk claims " + std::to_string(uncompressed_size) + " bytes"};
  }
  const auto size = static_cast<std::size_t>(uncompressed_size);
  std::optional<std::vector<std::uint8_t>> out;
  if (compression.empty()) {
    out = std::move(data);
  } else if (compression == "zstd") {
    out = expand_zstd(data, size);
  } else if (compression == "lz4") {
    out = expand_lz4_frames(data, size);
  } else {
    return Error{"it is compressed with '" + compression + "'; Farrier reads zstd, lz4 and uncompressed chunks"};
  }
  if (!out || out->size() != size) {
    return Error{"its bytes are damaged"};
  }
  return std::move(*out);
}

}  // namespace farrier::mcap
