#pragma once

#include <span>
#include <vector>

#include "locomotion/controller.hpp"

namespace farrier::locomotion {

/// A command from a time on.
struct TimedCommand {
  double from_s = 0.0;
  MotionCommand command;
};

inline constexpr double kStandUp_s = 2.5;  ///< begins to stand up, after the soft start
inline constexpr double kWalk_s = 8.0;     ///< begins to walk

/// Lies, stands up at kStandUp_s and trots with these velocities from kWalk_s on.
inline std::vector<TimedCommand> walk_script(const MotionCommand& trot) {
  return {{kStandUp_s, {.request = Request::kStand}}, {kWalk_s, trot}};
}

/// The command at a time: the last of the script that has begun, in the order of their times; before the first it lies.
inline MotionCommand command_at(std::span<const TimedCommand> script, double time_s) noexcept {
  MotionCommand command;
  for (const TimedCommand& timed : script) {
    if (timed.from_s <= time_s) {
      command = timed.command;
    }
  }
  return command;
}

}  // namespace farrier::locomotion
