#pragma once

#include "bus/network.hpp"

namespace farrier::bus_fastdds {

/// First index of at least `from` and below max_processes whose two well-known ports (RTPS 2.2, 9.6.1) nobody on this
/// computer holds; -1 when there is none. Fast DDS looks for free ports itself, but also beyond the last index at
/// which others look for processes.
int free_participant_index(const bus::NetworkOptions& options, int from) noexcept;

}  // namespace farrier::bus_fastdds
