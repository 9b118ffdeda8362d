#pragma once

#include <string>

#include "bus/qos.hpp"

namespace farrier::bus {

/// "reliable, keep last 4, transient local": for people. Discovery announces no history: leave it out there.
std::string qos_text(const Qos& qos, bool with_history = true);

}  // namespace farrier::bus
