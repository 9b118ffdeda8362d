#pragma once

#include <type_traits>

#include "signals/signals.hpp"

namespace farrier::signals {

/// Tick that a sample belongs to. kNoTick for a probe of the greeting, which is ignored, and for a hello, which has
/// none.
inline Tick tick_of(const GaitPhase& s) noexcept { return s.announced_tick; }
inline Tick tick_of(const SystemMode& s) noexcept { return s.effective_tick; }
inline Tick tick_of(const JointControllerGains& s) noexcept { return s.effective_tick; }
template <class Signal>
Tick tick_of(const Signal& s) noexcept {
  if constexpr (requires { s.tick; }) {
    return s.tick;
  }
  return kNoTick;
}

/// Orders stand until newer ones come, and are repeated meanwhile. Their tick is when they take effect, not when they
/// are sent.
template <class Signal>
inline constexpr bool kIsOrder = std::is_same_v<Signal, SystemMode> || std::is_same_v<Signal, JointControllerGains>;

/// True if a sample is a probe of the greeting. Always false for a hello, which has no tick.
template <class Signal>
bool is_probe(const Signal& s) noexcept {
  return !std::is_same_v<Signal, SystemHello> && tick_of(s) == kNoTick;
}

}  // namespace farrier::signals
