#pragma once

#include <string>

#include "bus/network.hpp"

namespace farrier::bus_cyclone {

/// Cyclone's configuration for `options`, as XML.
std::string cyclone_config(const bus::NetworkOptions& options);

}  // namespace farrier::bus_cyclone
