#include "core/fault.hpp"

#include <algorithm>

namespace farrier {
namespace {

const char* effect_of(SafeOutput output) noexcept {
  switch (output) {
    case SafeOutput::kTracking:
      return "tracking";
    case SafeOutput::kDamping:
      return "damping: `τ = −damping_gain_Nms_rad · q̇` through the force loop";
    case SafeOutput::kPositionDamping:
      return "position damping: the valve as a source of speed, `ẋ = −position_damping_1_s · (x − x₀)` from where the "
             "force was lost";
    case SafeOutput::kNull:
      return "valve to null";
  }
  return "?";
}

const char* text_of(Clears clears) noexcept {
  switch (clears) {
    case Clears::kWithCondition:
      return "with its condition";
    case Clears::kAfterGoodSamples:
      return "after `recovery_samples` good new samples";
    case Clears::kByArming:
      return "latched: by a newer mode that arms, which the supervisor publishes when an operator asks "
             "(`system/request` with the session)";
  }
  return "?";
}

std::string text_of_event(const FaultInfo& row) {
  if (row.event_text() == nullptr) {
    return "none";
  }
  const std::string lingers =
      row.event.lingers > 0 ? ", present for " + std::to_string(row.event.lingers) + " ticks after its last" : "";
  return "`" + std::string(row.event_text()) + "`" + lingers;
}

}  // namespace

const char* to_string(Fault fault) noexcept {
  for (const FaultInfo& info : kFaults) {
    if (info.fault == fault) {
      return info.name;
    }
  }
  return "unknown fault";
}

const char* to_string(FaultSeverity severity) noexcept {
  switch (severity) {
    case FaultSeverity::kInfo:
      return "info";
    case FaultSeverity::kWarning:
      return "warning";
    case FaultSeverity::kError:
      return "error";
    case FaultSeverity::kCritical:
      return "critical";
  }
  return "?";
}

std::string to_string(FaultSet faults) {
  std::string text;
  for (std::uint32_t bit = 1; bit != 0 && bit <= faults.bits(); bit <<= 1) {
    if ((faults.bits() & bit) != 0) {
      text += text.empty() ? "" : ", ";
      text += to_string(static_cast<Fault>(bit));
    }
  }
  return text;
}

std::string safety_table_markdown() {
  auto rows = kFaults;
  std::ranges::stable_sort(rows, std::ranges::greater{}, &FaultInfo::output);
  std::string table = "| condition | fault | output | clears | severity | event |\n|---|---|---|---|---|---|\n";
  for (const FaultInfo& row : rows) {
    table += "| " + std::string(row.condition) + " | `" + row.name + "` | " +
             (row.effect != nullptr ? row.effect : effect_of(row.output)) + " | " + text_of(row.clears) + " | " +
             to_string(row.severity) + " | " + text_of_event(row) + " |\n";
  }
  return table;
}

}  // namespace farrier
