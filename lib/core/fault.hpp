#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace farrier {

/// Faults a joint can be in, one bit each, which keep their places: they stand in recordings. Which decides the joint's
/// output is the table in docs/architecture.md.
enum class Fault : std::uint32_t {
  kDisarmed = 1u << 0,          ///< not armed for the present session: valve to null
  kTripped = 1u << 1,           ///< latched after a long loss of commands: valve to null until re-armed
  kSensorsStale = 1u << 2,      ///< sensors too old, or no position and velocity: valve to null
  kNoGains = 1u << 3,           ///< no accepted gains yet: valve to null
  kCommandStale = 1u << 4,      ///< command too old: damping only
  kGainsRefused = 1u << 5,      ///< a gain update was refused; the last good gains act
  kReferenceClamped = 1u << 6,  ///< force or position limit reached: reference clamped
  kValveSaturated = 1u << 7,    ///< valve current at its limit
  kActuatorSilent = 1u << 8,    ///< sim bridge: no valve command in time, spool to null
  kForceLost = 1u << 9,         ///< no force: the joint holds its position, softly
};

struct FaultInfo {
  Fault fault;
  const char* name;
  bool failed;  ///< the joint does not do what it is asked; with other faults it does, or waits to be armed
};

/// Every fault in the order of their bits. Terminal, page, metrics and recordings name and colour faults by this table.
inline constexpr std::array kFaults{
    FaultInfo{Fault::kDisarmed, "disarmed", false},
    FaultInfo{Fault::kTripped, "tripped", true},
    FaultInfo{Fault::kSensorsStale, "sensors stale", true},
    FaultInfo{Fault::kNoGains, "no gains", false},
    FaultInfo{Fault::kCommandStale, "command stale", true},
    FaultInfo{Fault::kGainsRefused, "gains refused", false},
    FaultInfo{Fault::kReferenceClamped, "reference clamped", false},
    FaultInfo{Fault::kValveSaturated, "valve saturated", false},
    FaultInfo{Fault::kActuatorSilent, "actuator silent", true},
    FaultInfo{Fault::kForceLost, "force lost", true},
};

/// Set of faults; trivially copyable, travels as its bits.
class FaultSet {
 public:
  constexpr FaultSet() = default;
  constexpr explicit FaultSet(std::uint32_t bits) : bits_(bits) {}

  constexpr void set(Fault fault, bool on = true) noexcept {
    const auto bit = static_cast<std::uint32_t>(fault);
    bits_ = on ? (bits_ | bit) : (bits_ & ~bit);
  }
  constexpr bool has(Fault fault) const noexcept { return (bits_ & static_cast<std::uint32_t>(fault)) != 0; }
  constexpr bool any() const noexcept { return bits_ != 0; }
  constexpr std::uint32_t bits() const noexcept { return bits_; }
  /// True if a joint with these faults has failed.
  constexpr bool failed() const noexcept {
    for (const FaultInfo& info : kFaults) {
      if (info.failed && has(info.fault)) {
        return true;
      }
    }
    return false;
  }
  friend constexpr bool operator==(FaultSet, FaultSet) = default;

 private:
  std::uint32_t bits_ = 0;
};

const char* to_string(Fault fault) noexcept;

/// "disarmed, command stale"; empty for no fault.
std::string to_string(FaultSet faults);

}  // namespace farrier
