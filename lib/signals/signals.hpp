#pragma once

// A trivially copyable struct per topic, written at build time from idl/ (from_idl/main.cpp). No vendor type appears
// outside the vendors' buses, which copy field by field along the lists in signals/fields.hpp.
//
// Coordinates are the actuator's: a cylinder's piston position in m (from retracted), velocity in m/s and load-cell
// force in N. For a rotary motor the same fields hold rad, rad/s and Nm, which their names say.

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>

#include "core/time.hpp"
#include "signals/octets.hpp"
#include "signals/structs.hpp"
#include "signals/words.hpp"

namespace farrier::signals {

/// Number of topics that a health report can count.
inline constexpr int kMaxTopics = std::tuple_size_v<decltype(SystemHealth::sent)>;

using Name = decltype(SystemHello::name);
using Text = decltype(SystemEvent::text);

/// Copies as much of `text` as fits, always zero-terminated.
template <std::size_t kSize>
void assign(std::array<char, kSize>& to, std::string_view text) noexcept {
  to.fill('\0');
  text.copy(to.data(), kSize - 1);
}

/// Up to the terminating zero; all of it when a sender has left that out.
template <std::size_t kSize>
std::string_view text_of(const std::array<char, kSize>& from) noexcept {
  const auto end = std::find(from.begin(), from.end(), '\0');
  return std::string_view(from.data(), static_cast<std::size_t>(end - from.begin()));
}

}  // namespace farrier::signals
