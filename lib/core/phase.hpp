#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace farrier {

/// Phase of a leg. Also names the slot of gains that acts in it. The numbers travel in signals.
enum class Phase : std::uint8_t { kSwing = 0, kStance = 1 };

constexpr const char* to_string(Phase phase) noexcept {
  switch (phase) {
    case Phase::kSwing:
      return "swing";
    case Phase::kStance:
      return "stance";
  }
  return "unknown phase";
}

inline constexpr int kPhaseCount = 2;

/// False for a number that names no phase; signals may carry one.
constexpr bool known(Phase phase) noexcept { return static_cast<int>(phase) < kPhaseCount; }

constexpr Phase other(Phase phase) noexcept { return phase == Phase::kSwing ? Phase::kStance : Phase::kSwing; }

/// A value for each phase. The phase must be known.
template <class T>
struct PerPhase : std::array<T, kPhaseCount> {
  using Values = std::array<T, kPhaseCount>;
  using Values::operator[];
  constexpr T& operator[](Phase phase) noexcept { return (*this)[static_cast<std::size_t>(phase)]; }
  constexpr const T& operator[](Phase phase) const noexcept { return (*this)[static_cast<std::size_t>(phase)]; }
};

}  // namespace farrier
