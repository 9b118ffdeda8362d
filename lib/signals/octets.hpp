#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace farrier::signals {

/// A byte sequence of variable size, at most kMost: a sequence with that bound in IDL.
template <std::size_t kMost>
class Octets {
 public:
  static constexpr std::size_t capacity() noexcept { return kMost; }

  constexpr std::uint32_t size() const noexcept { return size_; }
  /// Limits the size to the capacity. Added bytes keep the values that the storage had before.
  constexpr void resize(std::size_t size) noexcept { size_ = static_cast<std::uint32_t>(std::min(size, kMost)); }
  /// Copies as many bytes as there is room for.
  constexpr void assign(std::span<const std::uint8_t> octets) noexcept {
    resize(octets.size());
    std::copy_n(octets.begin(), size_, begin());
  }

  constexpr std::uint8_t* data() noexcept { return octets_.data(); }
  constexpr const std::uint8_t* data() const noexcept { return octets_.data(); }
  constexpr std::uint8_t* begin() noexcept { return data(); }
  constexpr std::uint8_t* end() noexcept { return data() + size_; }
  constexpr const std::uint8_t* begin() const noexcept { return data(); }
  constexpr const std::uint8_t* end() const noexcept { return data() + size_; }

  friend constexpr bool operator==(const Octets& one, const Octets& other) noexcept {
    return std::equal(one.begin(), one.end(), other.begin(), other.end());
  }

 private:
  std::uint32_t size_ = 0;
  std::array<std::uint8_t, kMost> octets_{};
};

template <class Field>
inline constexpr bool kIsOctets = false;
template <std::size_t kMost>
inline constexpr bool kIsOctets<Octets<kMost>> = true;
template <class Field>
inline constexpr bool kIsOctets<const Field> = kIsOctets<Field>;

}  // namespace farrier::signals
