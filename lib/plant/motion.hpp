#pragma once

namespace farrier::plant {

/// Position and velocity of an actuator, m and m/s or rad and rad/s.
struct Motion {
  double position = 0.0;
  double velocity = 0.0;
};

}  // namespace farrier::plant
