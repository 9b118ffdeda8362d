#pragma once

// Little-endian numbers, length-prefixed text and maps, as MCAP spells them.

#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "mcap/records.hpp"

namespace farrier::mcap {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

/// Bytes that grow.
class ByteWriter {
 public:
  template <std::integral T>
  void number(T value) {
    append(reinterpret_cast<const std::uint8_t*>(&value), sizeof value);
  }
  void text(const std::string& value) {
    number(static_cast<std::uint32_t>(value.size()));
    append(reinterpret_cast<const std::uint8_t*>(value.data()), value.size());
  }
  void bytes(std::span<const std::uint8_t> value) { append(value.data(), value.size()); }

  void map(const Text& values) {
    prefixed([&] {
      for (const auto& [key, value] : values) {
        text(key);
        text(value);
      }
    });
  }
  void map(const std::map<std::uint16_t, std::uint64_t>& values) {
    prefixed([&] {
      for (const auto& [key, value] : values) {
        number(key);
        number(value);
      }
    });
  }
  /// Appends the bytes that `fill` appends, preceded by their length.
  template <class Length = std::uint32_t, class Fill>
  void prefixed(Fill&& fill) {
    const std::size_t at = data_.size();
    number(Length{0});
    fill();
    const auto length = static_cast<Length>(data_.size() - at - sizeof(Length));
    std::memcpy(data_.data() + at, &length, sizeof length);
  }
  /// A record: its opcode, the length of its content, its content.
  template <class Fill>
  void record(Opcode opcode, Fill&& fill) {
    number(static_cast<std::uint8_t>(opcode));
    prefixed<std::uint64_t>(fill);
  }

  std::span<const std::uint8_t> view() const noexcept { return data_; }
  std::size_t size() const noexcept { return data_.size(); }
  void clear() noexcept { data_.clear(); }

 private:
  void append(const std::uint8_t* from, std::size_t count) { data_.insert(data_.end(), from, from + count); }

  std::vector<std::uint8_t> data_;
};

/// Reads bytes from their beginning. Reads past the end return 0 or empty, and set `good` to false.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> data) : rest_(data) {}

  template <std::integral T>
  T number() noexcept {
    T value{};
    if (const auto from = bytes(sizeof value); good_) {
      std::memcpy(&value, from.data(), sizeof value);
    }
    return value;
  }
  std::string text() {
    const auto from = bytes(number<std::uint32_t>());
    return {from.begin(), from.end()};
  }
  Text text_map() {
    Text values;
    for (ByteReader inner(bytes(number<std::uint32_t>())); good_ && !inner.rest_.empty();) {
      std::string key = inner.text();
      values[std::move(key)] = inner.text();
      good_ = inner.good_;
    }
    return values;
  }
  std::map<std::uint16_t, std::uint64_t> number_map() {
    std::map<std::uint16_t, std::uint64_t> values;
    for (ByteReader inner(bytes(number<std::uint32_t>())); good_ && !inner.rest_.empty();) {
      const auto key = inner.number<std::uint16_t>();
      values[key] = inner.number<std::uint64_t>();
      good_ = inner.good_;
    }
    return values;
  }
  std::span<const std::uint8_t> bytes(std::uint64_t count) noexcept {
    good_ = good_ && count <= rest_.size();
    if (!good_) {
      return {};
    }
    const auto taken = rest_.first(static_cast<std::size_t>(count));
    rest_ = rest_.subspan(static_cast<std::size_t>(count));
    return taken;
  }
  std::span<const std::uint8_t> rest() const noexcept { return rest_; }
  bool good() const noexcept { return good_; }

 private:
  std::span<const std::uint8_t> rest_;
  bool good_ = true;
};

}  // namespace farrier::mcap
