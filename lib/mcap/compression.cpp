#include "mcap/compression.hpp"

#include <zlib.h>
#include <zstd.h>

#include "core/ensure.hpp"

namespace farrier::mcap {
namespace {

constexpr int kLevel = -2;  // two thirds of the time of level 1, for chunks an eighth larger

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

Result<std::vector<std::uint8_t>> decompress(std::span<const std::uint8_t> data, const std::string& compression,
                                             std::uint64_t uncompressed_size) {
  if (uncompressed_size > kLargestChunk) {
    return Error{"a chunk claims " + std::to_string(uncompressed_size) + " bytes"};
  }
  const Error damaged{"the bytes of a chunk are damaged"};
  if (compression.empty()) {
    if (data.size() != uncompressed_size) {
      return damaged;
    }
    return std::vector<std::uint8_t>(data.begin(), data.end());
  }
  if (compression != "zstd") {
    return Error{"a chunk is compressed with '" + compression + "'; Farrier reads zstd and uncompressed chunks"};
  }
  if (ZSTD_getFrameContentSize(data.data(), data.size()) != uncompressed_size) {  // before room is made for a false claim
    return damaged;
  }
  std::vector<std::uint8_t> out(static_cast<std::size_t>(uncompressed_size));
  const std::size_t size = ZSTD_decompress(out.data(), out.size(), data.data(), data.size());
  if (ZSTD_isError(size) != 0 || size != uncompressed_size) {
    return damaged;
  }
  return out;
}

}  // namespace farrier::mcap
