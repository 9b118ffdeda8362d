#include "core/fault.hpp"

namespace farrier {

const char* to_string(Fault fault) noexcept {
  for (const FaultInfo& info : kFaults) {
    if (info.fault == fault) {
      return info.name;
    }
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
