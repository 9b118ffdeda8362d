#pragma once

// The bytes of a signal on the wire: plain CDR (XCDR1) of its final struct in idl/, little-endian, behind the four
// bytes that say so (OMG DDS-XTypes 1.3, 7.4; DDSI-RTPS 2.3, 10). Both vendors write the same, which a test holds them
// to.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "signals/fields.hpp"

namespace farrier::signals {

static_assert(std::endian::native == std::endian::little, "fields are copied as they are");

inline constexpr std::size_t kCdrHeadBytes = 4;

/// Calls at(offset, value) for every number of a field that starts at or behind `offset`; returns the offset behind it.
/// Offsets count from behind the head; a number lies at a multiple of its size.
template <class Field, class At>
std::size_t visit_cdr_numbers(std::size_t offset, Field& field, At&& at) {
  if constexpr (std::is_arithmetic_v<std::remove_const_t<Field>> || std::is_enum_v<std::remove_const_t<Field>>) {
    offset = (offset + sizeof(Field) - 1) / sizeof(Field) * sizeof(Field);
    at(offset, field);
    return offset + sizeof(Field);
  } else if constexpr (kIsOctets<Field>) {
    std::uint32_t count = field.size();
    offset = visit_cdr_numbers(offset, count, at);
    if constexpr (!std::is_const_v<Field>) {
      field.resize(count);
    }
    for (auto& one : field) {
      offset = visit_cdr_numbers(offset, one, at);
    }
    return offset;
  } else {
    for (auto& one : field) {
      offset = visit_cdr_numbers(offset, one, at);
    }
    return offset;
  }
}

/// Size of a signal's bytes, head included. A byte sequence, which comes last, counts as empty.
template <class Signal>
std::size_t cdr_size() {
  std::size_t offset = 0;
  visit_fields(Signal{}, [&](const char*, const auto& field) {
    offset = visit_cdr_numbers(offset, field, [](std::size_t, const auto&) {});
  });
  return kCdrHeadBytes + offset;
}

/// Number of bytes in a signal's byte sequence; 0 without such a field.
template <class Signal>
std::size_t octets_in(const Signal& signal) noexcept {
  std::size_t count = 0;
  visit_fields(signal, [&](const char*, const auto& field) {
    if constexpr (kIsOctets<std::remove_cvref_t<decltype(field)>>) {
      count += field.size();
    }
  });
  return count;
}

/// Writes cdr_size<Signal>() bytes and those of a byte sequence. Padding is left as it is, so it must be 0 before.
template <class Signal>
void write_cdr(const Signal& signal, std::uint8_t* bytes) noexcept {
  bytes[1] = 1;  // CDR_LE
  std::size_t offset = 0;
  visit_fields(signal, [&](const char*, const auto& field) {
    offset = visit_cdr_numbers(offset, field, [&](std::size_t place, const auto& number) {
      std::memcpy(bytes + kCdrHeadBytes + place, &number, sizeof number);
    });
  });
}

/// Replaces `bytes`. Padding is 0.
template <class Signal>
void to_cdr(const Signal& signal, std::vector<std::uint8_t>& bytes) {
  static const std::size_t size = cdr_size<Signal>();
  bytes.assign(size + octets_in(signal), 0);
  write_cdr(signal, bytes.data());
}

/// Largest number of bytes in a signal's byte sequence; 0 without such a field.
template <class Signal>
consteval std::size_t most_octets() {
  std::size_t most = 0;
  visit_fields(Signal{}, [&](const char*, const auto& field) {
    if constexpr (kIsOctets<std::remove_cvref_t<decltype(field)>>) {
      most += field.capacity();
    }
  });
  return most;
}

/// True for bytes that are little-endian CDR of such a signal.
template <class Signal>
bool is_cdr(std::span<const std::uint8_t> bytes) {
  static const std::size_t least = cdr_size<Signal>();
  if (bytes.size() < least || bytes[0] != 0 || bytes[1] != 1) {
    return false;
  }
  std::uint32_t octets = 0;
  if constexpr (most_octets<Signal>() > 0) {
    std::memcpy(&octets, bytes.data() + least - sizeof octets, sizeof octets);
  }
  const std::size_t size = least + octets;
  // Vendors may pad the end to a multiple of four.
  return octets <= most_octets<Signal>() && bytes.size() >= size && bytes.size() < size + kCdrHeadBytes;
}

/// False for bytes that are not little-endian CDR of this signal; the signal is then as it was.
template <class Signal>
bool from_cdr(std::span<const std::uint8_t> bytes, Signal& signal) {
  if (!is_cdr<Signal>(bytes)) {
    return false;
  }
  std::size_t offset = 0;
  visit_fields(signal, [&](const char*, auto& field) {
    offset = visit_cdr_numbers(offset, field, [&](std::size_t place, auto& number) {
      std::memcpy(&number, bytes.data() + kCdrHeadBytes + place, sizeof number);
    });
  });
  return true;
}

}  // namespace farrier::signals
