#pragma once

#include <memory>
#include <string>

#include "bus/bus.hpp"
#include "bus/inproc/inproc_bus.hpp"

namespace farrier::contract {

/// A DDS domain of this test process's own. Its ports stay below those Linux hands out by itself (32768).
int own_domain();

/// True when this build can make buses of `vendor`.
bool available(bus::Vendor vendor);

/// A new bus; the test fails hard when the vendor refuses. In-process buses of one test share `inproc`.
std::unique_ptr<bus::Bus> make_bus(bus::Vendor vendor, int domain, const std::shared_ptr<bus::InprocDomain>& inproc);

}  // namespace farrier::contract
