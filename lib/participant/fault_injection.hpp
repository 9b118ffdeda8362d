#pragma once

#include <memory>
#include <string>

#include "bus/bus.hpp"

namespace farrier::participant {

struct ProcessOptions;

/// Faults on the way of samples into a process. Programs that ship to a robot do not link any: `farrier faults` starts
/// other programs, of the same objects, that link farrier_fault_injection as well.
class FaultInjection {
 public:
  virtual ~FaultInjection() = default;

  /// Refuses a fault that it cannot read, with the reason.
  virtual Result<Done> check(const std::string& fault) const = 0;

  /// A bus with the faults of the options between `bus` and the process.
  virtual std::unique_ptr<bus::Bus> into(std::unique_ptr<bus::Bus> bus, const ProcessOptions& options) const = 0;
};

/// The one that the program links; null in programs that ship. Set before main() begins.
const FaultInjection*& fault_injection() noexcept;

}  // namespace farrier::participant
