#include "core/fault.hpp"

namespace farrier {

const char* to_string(Fault fault) noexcept {
  switch (fault) {
    case Fault::kDisarmed: return "disarmed";
    case Fault::kTripped: return "tripped";
    case Fault::kSensorsStale: return "sensors stale";
    case Fault::kNoGains: return "no gains";
    case Fault::kCommandStale: return "command stale";
    case Fault::kGainsRefused: return "gains refused";
    case Fault::kReferenceClamped: return "reference clamped";
    case Fault::kValveSaturated: return "valve saturated";
    case Fault::kActuatorSilent: return "actuator silent";
    case Fault::kForceLost: return "force lost";
  }
  return "unknown fault";
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

}  // namespace farrier
