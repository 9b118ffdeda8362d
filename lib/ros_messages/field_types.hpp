#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace farrier::ros_messages {

/// A string of at most `Bound` bytes.
template <std::size_t Bound>
struct BoundedString : std::string {
  using std::string::string;
  BoundedString(const std::string& text) : std::string(text) {}
};

// The kinds of fields that a message has.
template <class T>
inline constexpr std::size_t kBound = 0;
template <std::size_t Bound>
inline constexpr std::size_t kBound<BoundedString<Bound>> = Bound;
template <class T>
inline constexpr bool kIsString = std::is_same_v<T, std::string> || kBound<T> != 0;
template <class T>
inline constexpr bool kIsSequence = false;
template <class T>
inline constexpr bool kIsSequence<std::vector<T>> = true;
template <class T>
inline constexpr std::size_t kArraySize = 0;
template <class T, std::size_t Size>
inline constexpr std::size_t kArraySize<std::array<T, Size>> = Size;
template <class T>
concept Message = requires {
  T::kRosName;
};

}  // namespace farrier::ros_messages
