#pragma once

#include "monitor/frame.hpp"

namespace farrier::display {

/// A display of a monitor's frames. Several may be on at a time.
class Display {
 public:
  virtual ~Display() = default;
  /// Gets every frame, in order, some twenty a second.
  virtual void show(const monitor::Frame& frame) = 0;
  /// True if its user wants the monitor to end.
  virtual bool ended() const { return false; }
};

}  // namespace farrier::display
