#pragma once

#include <dds/dds.h>

#include <string>

namespace farrier::bus_cyclone {

/// The part of a GUID that all entities of a participant share, in hexadecimal digits.
inline std::string prefix_text(const dds_guid_t& guid) {
  constexpr std::size_t kPrefixBytes = 12;
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < kPrefixBytes; ++i) {
    text += kDigits[guid.v[i] >> 4];
    text += kDigits[guid.v[i] & 0xf];
  }
  return text;
}

}  // namespace farrier::bus_cyclone
