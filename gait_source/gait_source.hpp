#pragma once

#include <memory>

#include "participant/application.hpp"
#include "participant/participant.hpp"
#include "robot/robot.hpp"

namespace farrier::gait_source {

/// Which tick a touchdown is announced for: the planned one, as a robot would, or the one at which it will happen,
/// which only a simulation can know.
enum class Announce { kPlanned, kActual };

/// Plays the robot file's gait: when tick k begins it publishes the commands for tick k + 1 and the phase
/// announcements that are due, so it is never on the path from sensor to valve. The references follow the plan
/// whatever is announced. `ticks` 0: until told to stop.
class GaitSource : public participant::Application {
 public:
  static Result<std::unique_ptr<GaitSource>> create(const robot::Robot& robot, std::uint64_t seed,
                                                    participant::Participant& participant, Tick ticks,
                                                    Announce announce = Announce::kPlanned);

  /// Ticks whose commands were asked for so far.
  virtual Tick tick() const = 0;
};

}  // namespace farrier::gait_source
