#pragma once

namespace farrier::bus_cyclone {

/// Every timed wait of Cyclone in this process is on the steady clock. Calling this links what does it.
void wait_on_steady_clock() noexcept;

}  // namespace farrier::bus_cyclone
