#pragma once

// The safety table of a joint: a row per fault, with condition, output, clear condition, severity and event. joint_node
// runs it; joint_node/fault_assessor.cpp has the conditions in code, a line per row. Terminal, page, metrics, alerts,
// docs/architecture.md and the rows of `farrier faults` take names, severities, outputs and events from here.

#include <array>
#include <bit>
#include <cstdint>
#include <string>

#include "core/time.hpp"

namespace farrier {

/// Faults of a joint, one bit each. Recordings hold the bits, so a bit keeps its meaning.
enum class Fault : std::uint32_t {
  kDisarmed = 1u << 0,
  kTripped = 1u << 1,
  kSensorsStale = 1u << 2,
  kNoGains = 1u << 3,
  kCommandStale = 1u << 4,
  kGainsRefused = 1u << 5,
  kReferenceClamped = 1u << 6,
  kValveSaturated = 1u << 7,
  kActuatorSilent = 1u << 8,
  kForceLost = 1u << 9,
};

/// Outputs of a joint, each more careful than those before it. The most careful one of a joint's faults acts.
enum class SafeOutput : std::uint8_t { kTracking, kDamping, kPositionDamping, kNull };

/// The end of a fault: its latch and its debounce.
enum class Clears : std::uint8_t {
  kWithCondition,     ///< in the tick in which the condition ends
  kAfterGoodSamples,  ///< after Safety::recovery_samples new sensor samples without the condition
  kByArming,          ///< latched: by a newer mode that arms
};

/// Urgency of a fault for an operator. Alerts begin at a warning; from an error on the joint has failed.
enum class FaultSeverity : std::uint8_t { kInfo, kWarning, kError, kCritical };

/// The report of a fault in the joint's events.
struct FaultEvent {
  const char* text = nullptr;  ///< null: the fault's name
  Tick lingers = 0;            ///< the fault counts as present for this many ticks after its last one
  bool reported = true;
};
inline constexpr FaultEvent kNoEvent{nullptr, 0, false};

struct FaultInfo {
  Fault fault;
  const char* name;
  SafeOutput output;
  Clears clears;
  FaultSeverity severity;
  const char* condition;         ///< Markdown; limits by their names in section `safety` of the robot file
  const char* effect = nullptr;  ///< Markdown; null: the output's
  FaultEvent event{};

  /// Text of the fault's event; null for none.
  constexpr const char* event_text() const noexcept {
    return event.reported ? (event.text != nullptr ? event.text : name) : nullptr;
  }
  /// True if a joint with this fault does not do what it is asked. With other faults it does, or waits to be armed.
  constexpr bool failed() const noexcept { return severity >= FaultSeverity::kError; }
  constexpr bool latched() const noexcept { return clears == Clears::kByArming; }
};

/// Every fault in the order of their bits.
inline constexpr std::array kFaults = [] {
  using enum Fault;
  using enum SafeOutput;
  using enum Clears;
  using enum FaultSeverity;
  // clang-format off
  return std::array{
      FaultInfo{kDisarmed, "disarmed", kNull, kWithCondition, kInfo, "no mode `armed` of this session in effect"},
      FaultInfo{kTripped, "tripped", kNull, kByArming, kCritical, "armed, and the last command is older than `command_trip_s`, or the joint_node made no step for as long"},
      FaultInfo{kSensorsStale, "sensors stale", kNull, kAfterGoodSamples, kError, "sensors older than `sensors_stale_s`; position or velocity not finite; all numbers alike for `frozen_samples` samples; more than a tenth of the stroke beyond the stops; or a jump of a tenth of the stroke per tick"},
      FaultInfo{kNoGains, "no gains", kNull, kWithCondition, kInfo, "no gains for the phase yet (controllers `lqr` and `flow_inversion`)"},
      FaultInfo{kCommandStale, "command stale", kDamping, kWithCondition, kError, "command older than `command_damping_s`, or not finite, or with negative stiffness or damping"},
      FaultInfo{kGainsRefused, "gains refused", kTracking, kWithCondition, kWarning, "gains not finite, out of range, without integral action, compliant with a position gain, or closed loop unstable for the model they came with; until good ones act", "the last good gains act; an event has the reason"},
      FaultInfo{kReferenceClamped, "reference clamped", kTracking, kWithCondition, kInfo, "position reference outside the joint's limits, or force reference above the limit of supply and actuator", "the reference is clamped", {"reference clamped", 100}},
      FaultInfo{kValveSaturated, "valve saturated", kTracking, kWithCondition, kInfo, "valve current at its limit", "the integrator stops winding up", kNoEvent},
      FaultInfo{kActuatorSilent, "actuator silent", kNull, kWithCondition, kError, "`sim_bridge`, real time: no valve command for `valve_silent_s`", "spool to null", {"valve commands silent"}},
      FaultInfo{kForceLost, "force lost", kPositionDamping, kAfterGoodSamples, kError, "force not finite, or more than 5 times the joint's limits without a stop that pushes"},
  };
  // clang-format on
}();

static_assert(
    [] {
      for (std::size_t bit = 0; bit < kFaults.size(); ++bit) {
        if (static_cast<std::uint32_t>(kFaults[bit].fault) != 1u << bit) {
          return false;
        }
      }
      return true;
    }(),
    "the table is indexed by the bits of Fault");

/// The row of a fault, which must be in the table.
constexpr const FaultInfo& info_of(Fault fault) noexcept {
  return kFaults[static_cast<std::size_t>(std::countr_zero(static_cast<std::uint32_t>(fault)))];
}

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
      if (info.failed() && has(info.fault)) {
        return true;
      }
    }
    return false;
  }
  /// Output of a joint with these faults.
  constexpr SafeOutput output() const noexcept {
    SafeOutput most_careful = SafeOutput::kTracking;
    for (const FaultInfo& info : kFaults) {
      if (has(info.fault) && info.output > most_careful) {
        most_careful = info.output;
      }
    }
    return most_careful;
  }
  friend constexpr bool operator==(FaultSet, FaultSet) = default;

 private:
  std::uint32_t bits_ = 0;
};

const char* to_string(Fault fault) noexcept;
const char* to_string(FaultSeverity severity) noexcept;

/// "disarmed, command stale"; empty for no fault.
std::string to_string(FaultSet faults);

/// Markdown table of all faults, the most careful output first, for docs/architecture.md.
std::string safety_table_markdown();

}  // namespace farrier
