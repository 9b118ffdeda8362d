#pragma once

// The types idlc generates from idl/, paired with our signals.

#include "signals/cyclone_types.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>

#include "signals/fields.hpp"

namespace farrier::bus_cyclone {

template <class T>
void copy_field(T& to, const T& from) noexcept {
  to = from;
}
template <class Enum>
requires std::is_enum_v<Enum>
void copy_field(std::uint8_t& to, const Enum& from) noexcept { to = static_cast<std::uint8_t>(from); }
template <class Enum>
requires std::is_enum_v<Enum>
void copy_field(Enum& to, const std::uint8_t& from) noexcept { to = static_cast<Enum>(from); }
template <class T, std::size_t kCount>
void copy_field(T (&to)[kCount], const std::array<T, kCount>& from) noexcept {
  std::copy(from.begin(), from.end(), to);
}
template <class T, std::size_t kCount>
void copy_field(std::array<T, kCount>& to, const T (&from)[kCount]) noexcept {
  std::copy(from, from + kCount, to.begin());
}

// A sequence to be written points to the signal's own bytes; one that was read keeps what Cyclone allocated.
template <class Sequence, std::size_t kMost>
void copy_field(Sequence& to, const signals::Octets<kMost>& from) noexcept {
  to = {from.size(), from.size(), const_cast<std::uint8_t*>(from.data()), false};
}
template <class Sequence, std::size_t kMost>
void copy_field(signals::Octets<kMost>& to, const Sequence& from) noexcept {
  to.assign({from._buffer, from._length});
}

/// The generated type of a signal, and the copies between the two.
template <class Signal>
struct Wire;

#define FARRIER_COPY_FIELD(field) copy_field(to.field, from.field);
#define FARRIER_WIRE(Signal, file)                                                                                   \
  template <>                                                                                                        \
  struct Wire<signals::Signal> {                                                                                     \
    using Type = wire_##Signal;                                                                                      \
    static const dds_topic_descriptor_t& descriptor() { return wire_##Signal##_desc; }                               \
    static void copy(Type& to, const signals::Signal& from) noexcept { FARRIER_FIELDS_##Signal(FARRIER_COPY_FIELD) } \
    static void copy(signals::Signal& to, const Type& from) noexcept { FARRIER_FIELDS_##Signal(FARRIER_COPY_FIELD) } \
  };
FARRIER_SIGNALS(FARRIER_WIRE)
#undef FARRIER_WIRE
#undef FARRIER_COPY_FIELD

}  // namespace farrier::bus_cyclone
