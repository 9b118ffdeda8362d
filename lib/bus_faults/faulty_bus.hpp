#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bus/bus.hpp"
#include "bus_faults/arrow_fault.hpp"
#include "bus_faults/due_times.hpp"

namespace farrier::bus_faults {

/// `inner`, with faults on the way of samples into this process; whatever the vendor. Probes of the greeting, which
/// belong to no tick, come through unharmed. What is drawn depends on `seed`, on `name` (of the process) and on how many
/// samples came before; `clock` is the steady one. For the real-time clock: in lock-step a lost sample holds the run up
/// for ever.
std::unique_ptr<bus::Bus> with_faults(std::unique_ptr<bus::Bus> inner, std::vector<ArrowFault> faults,
                                      std::uint64_t seed, const std::string& name, Clock clock);

}  // namespace farrier::bus_faults
