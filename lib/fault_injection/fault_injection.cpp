// Faults of samples for the programs that `farrier faults` starts. Linking this file is what makes them possible.

#include "participant/fault_injection.hpp"

#include "bus_faults/faulty_bus.hpp"
#include "participant/clock.hpp"
#include "participant/options.hpp"

namespace farrier::fault_injection {
namespace {

class ArrowFaults final : public participant::FaultInjection {
 public:
  Result<Done> check(const std::string& fault) const override {
    FARRIER_TRY(bus_faults::parse_arrow_fault(fault));
    return Done{};
  }
  std::unique_ptr<bus::Bus> into(std::unique_ptr<bus::Bus> bus,
                                 const participant::ProcessOptions& options) const override {
    std::vector<bus_faults::ArrowFault> faults;
    for (const std::string& text : options.faults) {
      faults.push_back(bus_faults::parse_arrow_fault(text).value());
    }
    return bus_faults::with_faults(std::move(bus), std::move(faults), options.seed, options.name,
                                   {participant::steady_now, options.slow});
  }
};

const ArrowFaults kFaults;
[[maybe_unused]] const bool kLinked = (participant::fault_injection() = &kFaults) != nullptr;

}  // namespace
}  // namespace farrier::fault_injection
