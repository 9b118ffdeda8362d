#pragma once

#include <memory>
#include <vector>

#include "joint_node/ports.hpp"
#include "participant/realtime_loop.hpp"

namespace farrier::joint_node {

/// The joints of one process on the real-time clock: steps when every hosted joint has fresh sensors, at the latest
/// one and a half periods after the last step. Ages are on this computer's steady clock.
Result<std::unique_ptr<participant::RealtimeApplication>> create_realtime(const robot::Robot& robot,
                                                                          const std::vector<std::string>& joints,
                                                                          participant::Participant& participant);

}  // namespace farrier::joint_node
