#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "signals/signals.hpp"

namespace farrier::signals {

/// The name that IDL has for a number of a signal.
template <class T>
struct IdlType;
template <>
struct IdlType<char> {
  static constexpr const char* kName = "char";
};
template <>
struct IdlType<double> {
  static constexpr const char* kName = "double";
};
template <>
struct IdlType<std::uint8_t> {
  static constexpr const char* kName = "octet";
};
template <>
struct IdlType<std::uint16_t> {
  static constexpr const char* kName = "unsigned short";
};
template <>
struct IdlType<std::uint32_t> {
  static constexpr const char* kName = "unsigned long";
};
template <>
struct IdlType<std::uint64_t> {
  static constexpr const char* kName = "unsigned long long";
};
template <>
struct IdlType<std::int64_t> {
  static constexpr const char* kName = "long long";
};

/// A field as IDL declares it, without the semicolon: "double a[9]".
template <class T>
std::string idl_text(const char* name, const T&) {
  return std::string(IdlType<T>::kName) + ' ' + name;
}
template <class T, std::size_t kCount>
std::string idl_text(const char* name, const std::array<T, kCount>&) {
  return std::string(IdlType<T>::kName) + ' ' + name + '[' + std::to_string(kCount) + ']';
}
template <std::size_t kMost>
std::string idl_text(const char* name, const Octets<kMost>&) {
  return "sequence<octet, " + std::to_string(kMost) + "> " + name;
}

}  // namespace farrier::signals
