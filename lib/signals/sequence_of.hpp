#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "signals/signals.hpp"

namespace farrier::signals {

/// What comes once in every tick from each of its senders.
template <class Signal>
inline constexpr bool kOfEveryTick =
    std::is_same_v<Signal, JointSensors> || std::is_same_v<Signal, JointCommand> ||
    std::is_same_v<Signal, JointValveCommand> || std::is_same_v<Signal, JointMeasurement> ||
    std::is_same_v<Signal, ClockTick> || std::is_same_v<Signal, ClockTickDone>;

/// What rises by one from one sample of a stream to the next, so that a step of more says how many were lost: the tick
/// of what comes in every tick, the count of what is counted. Empty: a sample that does not tell.
template <class Signal>
std::optional<std::uint64_t> sequence_of(const Signal& s) noexcept {
  if constexpr (kOfEveryTick<Signal>) {
    return s.tick == kNoTick ? std::nullopt : std::optional(static_cast<std::uint64_t>(s.tick));
  } else if constexpr (std::is_same_v<Signal, GaitPhase> || std::is_same_v<Signal, SystemEvent>) {
    return s.count == 0 ? std::nullopt : std::optional<std::uint64_t>(s.count);
  } else if constexpr (std::is_same_v<Signal, SystemMode>) {
    return s.epoch == 0 ? std::nullopt : std::optional<std::uint64_t>(s.epoch);
  } else {
    return std::nullopt;
  }
}

}  // namespace farrier::signals
