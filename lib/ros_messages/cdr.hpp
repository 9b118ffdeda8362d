#pragma once

// Messages as bytes of the representation that ROS 2 uses on DDS, in Foxglove and in bags: plain CDR (XCDR1), little-endian.
// Alignment counts from behind the header of four bytes (RTPS 2.2, section 10.2; XTypes 1.3, 7.4.1).

#include <bit>
#include <cstring>
#include <optional>
#include <span>

#include "ros_messages/messages.hpp"

namespace farrier::ros_messages {

static_assert(std::endian::native == std::endian::little);

/// Header of every message: CDR, little-endian, no options.
inline constexpr std::array<std::uint8_t, 4> kCdrHeader = {0, 1, 0, 0};

/// Visitor that appends fields to bytes.
class CdrWriter {
 public:
  explicit CdrWriter(std::vector<std::uint8_t>& bytes) : bytes_(bytes) {
    bytes_.assign(kCdrHeader.begin(), kCdrHeader.end());
  }

  template <class T>
  void operator()(const char* /*name*/, const T& field) {
    write(field);
  }

 private:
  template <class T>
  void write(const T& field) {
    if constexpr (Message<T>) {
      T::visit(field, *this);
    } else if constexpr (kIsString<T>) {
      write(static_cast<std::uint32_t>(field.size() + 1));
      bytes_.insert(bytes_.end(), field.begin(), field.end());
      bytes_.push_back(0);
    } else if constexpr (kIsSequence<T>) {
      write(static_cast<std::uint32_t>(field.size()));
      for (const auto& element : field) {
        write(element);
      }
    } else if constexpr (kArraySize<T> != 0) {
      for (const auto& element : field) {
        write(element);
      }
    } else {
      const std::size_t at =
          (bytes_.size() - kCdrHeader.size() + sizeof(T) - 1) / sizeof(T) * sizeof(T) + kCdrHeader.size();
      bytes_.resize(at + sizeof(T), 0);
      std::memcpy(bytes_.data() + at, &field, sizeof(T));
    }
  }

  std::vector<std::uint8_t>& bytes_;
};

/// Visitor that reads fields from bytes. After bytes that are no such message `good()` is false.
class CdrReader {
 public:
  /// `bytes` begin with the header.
  explicit CdrReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {
    good_ = bytes.size() >= kCdrHeader.size() && bytes[0] == kCdrHeader[0] && bytes[1] == kCdrHeader[1];
  }

  template <class T>
  void operator()(const char* /*name*/, T& field) {
    read(field);
  }
  bool good() const noexcept { return good_; }

 private:
  /// Moves past so many bytes at this alignment; null, and no longer good, if they are not there.
  const std::uint8_t* take(std::size_t size, std::size_t alignment) {
    const std::size_t at = (at_ - kCdrHeader.size() + alignment - 1) / alignment * alignment + kCdrHeader.size();
    good_ = good_ && at <= bytes_.size() && size <= bytes_.size() - at;
    if (!good_) {
      return nullptr;
    }
    at_ = at + size;
    return bytes_.data() + at;
  }

  std::uint32_t length() {
    std::uint32_t count = 0;
    read(count);
    good_ = good_ && count <= bytes_.size();  // no element is shorter than a byte
    return good_ ? count : 0;
  }

  template <class T>
  void read(T& field) {
    if (!good_) {
      return;
    }
    if constexpr (Message<T>) {
      T::visit(field, *this);
    } else if constexpr (kIsString<T>) {
      const std::uint32_t size = length();
      const std::uint8_t* const text = take(size, 1);
      good_ = good_ && size > 0 && text[size - 1] == 0 && (kBound<T> == 0 || size - 1 <= kBound<T>);
      if (good_) {
        field.assign(reinterpret_cast<const char*>(text), size - 1);
      }
    } else if constexpr (kIsSequence<T>) {
      const std::uint32_t count = length();
      field.clear();
      for (std::uint32_t i = 0; i < count && good_; ++i) {
        read(field.emplace_back());
      }
    } else if constexpr (kArraySize<T> != 0) {
      for (auto& element : field) {
        read(element);
      }
    } else if constexpr (std::is_same_v<T, bool>) {
      if (const std::uint8_t* const from = take(1, 1)) {
        field = *from != 0;
        good_ = *from <= 1;
      }
    } else if (const std::uint8_t* const from = take(sizeof(T), sizeof(T))) {
      std::memcpy(&field, from, sizeof(T));
    }
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = kCdrHeader.size();
  bool good_;
};

/// The bytes of a message, header first, into `bytes`.
template <Message M>
void to_cdr(const M& message, std::vector<std::uint8_t>& bytes) {
  CdrWriter writer(bytes);
  M::visit(message, writer);
}

/// The message of these bytes; none if they are no such message or are cut off. Bytes behind it are ignored.
template <Message M>
std::optional<M> from_cdr(std::span<const std::uint8_t> bytes) {
  M message;
  CdrReader reader(bytes);
  M::visit(message, reader);
  return reader.good() ? std::optional<M>(std::move(message)) : std::nullopt;
}

}  // namespace farrier::ros_messages
