#pragma once

#include "locomotion/controller.hpp"

namespace farrier::trials {

/// What the operator asks for from a time on.
struct TimedCommand {
  double from_s = 0.0;
  locomotion::MotionCommand command;
};

}  // namespace farrier::trials
