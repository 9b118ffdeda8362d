#pragma once

#include <array>
#include <cstdint>

#include "core/choice.hpp"

namespace farrier {

/// The implementation that carries a process's samples. The number travels in SystemHello.
enum class Vendor : std::uint8_t { kInproc = 0, kCyclone = 1, kFast = 2 };
inline constexpr std::array kVendors{Option<Vendor>{"inproc", Vendor::kInproc},
                                     Option<Vendor>{"cyclone", Vendor::kCyclone},
                                     Option<Vendor>{"fast", Vendor::kFast}};
/// The vendors whose processes find each other over a network.
inline constexpr std::array kDdsVendors{kVendors[1], kVendors[2]};

/// "cyclone"; "unknown vendor" for a number that a sample brought and that names none.
constexpr const char* to_string(Vendor vendor) noexcept {
  for (const Option<Vendor>& option : kVendors) {
    if (option.value == vendor) {
      return option.name;
    }
  }
  return "unknown vendor";
}

/// The clock that paces a run.
enum class ClockKind : std::uint8_t { kLockstep, kRealtime };
inline constexpr std::array kClockKinds{Option<ClockKind>{"lockstep", ClockKind::kLockstep},
                                        Option<ClockKind>{"realtime", ClockKind::kRealtime}};

}  // namespace farrier
