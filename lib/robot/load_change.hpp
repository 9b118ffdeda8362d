#pragma once

#include <cstdint>

#include "core/time.hpp"
#include "plant/actuator.hpp"

namespace farrier::robot {

/// From this tick on the load of a joint is this one, whatever the phase of its leg.
struct LoadChange {
  Tick tick = 0;
  std::uint16_t joint = 0;  ///< its place in Robot::joints
  plant::LoadParams load;   ///< actuator coordinates
};

}  // namespace farrier::robot
