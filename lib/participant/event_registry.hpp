#pragma once

#include <span>
#include <string>
#include <string_view>

#include "signals/signals.hpp"

namespace farrier::participant {

/// Events that a process of the robot may report, in the order of docs/events.md.
enum class EventKind : std::uint8_t {
  kJointNulled,
  kJointFaults,
  kGainsRefused,
  kReplacedSupervisorRefused,
  kGainsKept,
  kSupervisorLeads,
  kSupervisorStandsBy,
  kOperatorRequest,
  kEstimatesBegin,
  kValveSilent,
  kValveHeard,
  kEstimatesSilent,
  kEstimatesHeard,
  kSupervisorSilent,
  kSupervisorHeard,
  kSupplyLow,
  kSupplyRecovered,
  kSupplySlow,
  kSupplyFast,
  kSupplyStand,
  kSupplyLie,
  kJointDead,
  kTraceIncomplete,
  kWorldFailed,
  kNumberTaken,
  kSecurity,
  kFaultOnPurpose,
};

struct EventSpec {
  EventKind kind;
  const char* text;     ///< the text before its first angle bracket is printed as it is, then the values of the
                        ///< brackets
  const char* writers;  ///< processes
  signals::Severity severity;
  const char* meaning;
  const char* remedy;  ///< what an operator does; empty: nothing
};

/// Every kind, by number.
std::span<const EventSpec> event_specs() noexcept;
const EventSpec& spec(EventKind kind) noexcept;

/// Returns the text of an event.
std::string text_of(EventKind kind, std::string_view detail);

/// Markdown table of every kind, for docs/events.md.
std::string events_table_markdown();

}  // namespace farrier::participant
