#pragma once

#include <memory>
#include <string>
#include <vector>

#include "participant/application.hpp"
#include "participant/participant.hpp"
#include "robot/robot.hpp"

namespace farrier::bench {

/// The samples of a lock-step run between the same participants, counted instead of used: nothing is simulated,
/// controlled or recorded. Shows the speed of the transport alone, as a baseline for the stack. `joints`: those a joint
/// node hosts; the participant's number gives its role.
Result<std::unique_ptr<participant::Application>> create_bare(const robot::Robot& robot,
                                                              const std::vector<std::string>& joints, bool has_body,
                                                              participant::Participant& participant, Tick ticks);

}  // namespace farrier::bench
