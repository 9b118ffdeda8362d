#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "signals/signals.hpp"

namespace farrier::signals {

/// True for signals that come once per tick from each sender.
template <class Signal>
inline constexpr bool kOfEveryTick =
    std::is_same_v<Signal, JointSensors> || std::is_same_v<Signal, JointCommand> ||
    std::is_same_v<Signal, JointValveCommand> || std::is_same_v<Signal, JointMeasurement> ||
    std::is_same_v<Signal, ClockTick> || std::is_same_v<Signal, ClockTickDone> || std::is_same_v<Signal, BodyImu> ||
    std::is_same_v<Signal, BodyTruth> || std::is_same_v<Signal, BodyState>;

/// Number that rises by one per sample of a stream, so that a larger step gives the number of lost samples. It is the
/// tick of signals that come in every tick, and the counter of those that have one. Empty for a sample without either.
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
