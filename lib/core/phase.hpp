#pragma once

#include <cstdint>

namespace farrier {

/// Phase of a leg. Also names the slot of gains that acts in it. The numbers travel in signals.
enum class Phase : std::uint8_t { kSwing = 0, kStance = 1 };

constexpr const char* to_string(Phase phase) noexcept {
  switch (phase) {
    case Phase::kSwing: return "swing";
    case Phase::kStance: return "stance";
  }
  return "unknown phase";
}

}  // namespace farrier
