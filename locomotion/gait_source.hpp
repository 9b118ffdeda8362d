#pragma once

#include "locomotion/locomotion.hpp"

namespace farrier::locomotion {

/// Which tick a touchdown is announced for: the planned one, as a robot would, or the one at which it will happen,
/// which only a simulation can know.
enum class Announce { kPlanned, kActual };

/// Plays the robot file's gait, for joints on a bench. The references follow the plan whatever is announced. `ticks` 0:
/// until told to stop.
Result<std::unique_ptr<Locomotion>> create_gait_source(const robot::Robot& robot, std::uint64_t seed,
                                                       participant::Participant& participant, Tick ticks,
                                                       Announce announce = Announce::kPlanned);

}  // namespace farrier::locomotion
