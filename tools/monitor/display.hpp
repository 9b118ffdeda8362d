#pragma once

#include "monitor/frame.hpp"

namespace farrier::display {

/// What a monitor's frames are shown on. Several may be on at a time.
class Display {
 public:
  virtual ~Display() = default;
  /// Gets every frame, in order, some twenty a second.
  virtual void show(const monitor::Frame& frame) = 0;
  /// Whether its user wants the monitor to end.
  virtual bool ended() const { return false; }
};

}  // namespace farrier::display
