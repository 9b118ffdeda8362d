#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bus/bus.hpp"
#include "bus_faults/arrow_fault.hpp"
#include "bus_faults/due_times.hpp"

namespace farrier::bus_faults {

/// Wraps `inner`, of any vendor, with faults on the way of samples into this process. Probes of the greeting, which
/// belong to no tick, come through unharmed. Random numbers depend on `seed`, on `name` (of the process) and on the
/// number of samples before. `clock` is the steady one. Only for the real-time clock: in lock-step a lost sample blocks
/// the run for ever.
std::unique_ptr<bus::Bus> with_faults(std::unique_ptr<bus::Bus> inner, std::vector<ArrowFault> faults,
                                      std::uint64_t seed, const std::string& name, Clock clock);

}  // namespace farrier::bus_faults
