#pragma once

#include <chrono>

namespace farrier::bus_cyclone {

/// The longest wait of a datagram in the socket of a process that is in no hurry.
inline constexpr std::chrono::milliseconds kGatheringTime{2};

/// From now on, each receive thread of Cyclone with a socket of its own sleeps for kGatheringTime once that socket is
/// empty. Datagrams of that time are then received without another wake-up. For the whole process, until it ends.
void gather_arrivals() noexcept;

}  // namespace farrier::bus_cyclone
