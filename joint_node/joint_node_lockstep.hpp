#pragma once

#include <memory>
#include <vector>

#include "joint_node/joint_node.hpp"
#include "joint_node/ports.hpp"
#include "participant/application.hpp"

namespace farrier::joint_node {

/// The joints of one process in lock-step: tick k is stepped when the sensors and the command of tick k are there
/// and every gain update, mode change and phase announcement they ask for. No race can change a result.
Result<std::unique_ptr<participant::Application>> create_lockstep(const robot::Robot& robot,
                                                                  const std::vector<std::string>& joints,
                                                                  participant::Participant& participant, Tick ticks);

}  // namespace farrier::joint_node
