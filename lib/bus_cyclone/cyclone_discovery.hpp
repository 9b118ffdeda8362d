#pragma once

#include "bus/discovery.hpp"
#include "bus/network.hpp"
#include "core/result.hpp"
#include "core/time.hpp"

namespace farrier::bus_cyclone {

/// Joins a domain for that long and says who and what of both vendors was found there.
Result<bus::Discovery> discover(const bus::NetworkOptions& options, Nanoseconds how_long);

}  // namespace farrier::bus_cyclone
