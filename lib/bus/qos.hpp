#pragma once

#include <chrono>
#include <cstdint>

#include "core/time.hpp"

namespace farrier::bus {

enum class Reliability : std::uint8_t { kBestEffort, kReliable };
enum class Durability : std::uint8_t { kVolatile, kTransientLocal };
enum class Liveliness : std::uint8_t { kAutomatic, kManualByTopic };
enum class Ownership : std::uint8_t { kShared, kExclusive };

inline constexpr Nanoseconds kInfinite = Nanoseconds::max();

/// QoS of a topic. PRESENTATION, DESTINATION_ORDER and LATENCY_BUDGET are left at their default on every bus: the
/// vendors do not agree on checking them.
struct Qos {
  Reliability reliability = Reliability::kReliable;
  Durability durability = Durability::kVolatile;
  int history_depth = 1;  ///< KEEP_LAST, per key, >= 1
  Nanoseconds deadline = kInfinite;
  Liveliness liveliness = Liveliness::kAutomatic;
  Nanoseconds lease = kInfinite;
  Ownership ownership = Ownership::kShared;

  friend constexpr bool operator==(const Qos&, const Qos&) = default;
};

}  // namespace farrier::bus
