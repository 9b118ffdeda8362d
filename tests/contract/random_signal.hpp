#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <type_traits>
#include <vector>

#include "signals/fields.hpp"

namespace farrier::contract {

inline void randomise(double& field, std::mt19937_64& random) {
  field = std::uniform_real_distribution<double>(-1e6, 1e6)(random);
}
template <class Integer>
requires std::is_integral_v<Integer>
void randomise(Integer& field, std::mt19937_64& random) { field = static_cast<Integer>(random()); }
template <class Enum>
requires std::is_enum_v<Enum>
void randomise(Enum& field, std::mt19937_64& random) { field = static_cast<Enum>(static_cast<std::uint8_t>(random())); }
template <class T, std::size_t kCount>
void randomise(std::array<T, kCount>& field, std::mt19937_64& random) {
  for (T& element : field) {
    randomise(element, random);
  }
}

template <std::size_t kMost>
void randomise(signals::Octets<kMost>& field, std::mt19937_64& random) {
  field.resize(std::uniform_int_distribution<std::size_t>(0, kMost)(random));
  for (std::uint8_t& octet : field) {
    randomise(octet, random);
  }
}

/// A signal with every bit of every field at random (doubles finite, chars any byte).
template <class Signal>
Signal random_signal(std::mt19937_64& random) {
  Signal signal;
  signals::visit_fields(signal, [&](const char*, auto& field) { randomise(field, random); });
  return signal;
}

/// The fields of a signal, byte for byte and without padding.
template <class Signal>
std::vector<std::byte> bytes_of(const Signal& signal) {
  std::vector<std::byte> bytes;
  signals::visit_fields(signal, [&](const char*, const auto& field) {
    const auto append = [&](const void* from, std::size_t count) {
      const auto* const begin = static_cast<const std::byte*>(from);
      bytes.insert(bytes.end(), begin, begin + count);
    };
    if constexpr (signals::kIsOctets<std::remove_cvref_t<decltype(field)>>) {
      append(field.data(), field.size());
    } else {
      append(&field, sizeof field);
    }
  });
  return bytes;
}

}  // namespace farrier::contract
