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
void randomise(Integer& field, std::mt19937_64& random) {
  field = static_cast<Integer>(random());
}
template <class T, std::size_t kCount>
void randomise(std::array<T, kCount>& field, std::mt19937_64& random) {
  for (T& element : field) {
    randomise(element, random);
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
    const std::size_t start = bytes.size();
    bytes.resize(start + sizeof(field));
    std::memcpy(&bytes[start], &field, sizeof(field));
  });
  return bytes;
}

}  // namespace farrier::contract
