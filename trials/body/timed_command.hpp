#pragma once

#include "locomotion/controller.hpp"

namespace farrier::trials {

/// A command of the operator that holds from a time on.
struct TimedCommand {
  double from_s = 0.0;
  locomotion::MotionCommand command;
};

}  // namespace farrier::trials
