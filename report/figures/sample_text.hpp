#pragma once

#include <string>

#include "robot/robot.hpp"
#include "signals/fields.hpp"

namespace farrier::report {

/// "{joint: lf_kfe, tick: 155, state: tracking, ...}": every field in wire order, as YAML reads it. Joints have their
/// names, states and phases their words; what is no number of either stays a number.
#define FARRIER_SAMPLE_TEXT(Signal, file) \
  std::string sample_text(const signals::Signal& signal, const robot::Robot& robot);
FARRIER_SIGNALS(FARRIER_SAMPLE_TEXT)
#undef FARRIER_SAMPLE_TEXT

}  // namespace farrier::report
