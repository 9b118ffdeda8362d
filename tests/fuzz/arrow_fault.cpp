// Faults as people write them on a command line.

#include "bus_faults/arrow_fault.hpp"

#include "tests/fuzz/harness.hpp"

namespace farrier::fuzz {

void arrow_fault(Bytes bytes) {
  const auto fault = bus_faults::parse_arrow_fault(std::string(text_of(bytes)));
  if (!fault) {
    require(!fault.error().message.empty(), "a refusal says why");
    return;
  }
  const auto again = bus_faults::parse_arrow_fault(to_string(fault.value()));
  require(again.ok() && again.value() == fault.value(), "a fault as text is read as the same fault");
}

}  // namespace farrier::fuzz
