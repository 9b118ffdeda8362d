#pragma once

#include <memory>

#include "participant/application.hpp"
#include "participant/participant.hpp"
#include "robot/robot.hpp"
#include "supervisor/supervisor.hpp"

namespace farrier::supervisor {

/// The supervisor on its ports, on either clock. In lock-step it works on the estimates of tick k - 1 in tick k. With
/// `ticks` 0 it runs until told to stop. With `stands_by`, real time only, it leads once the leading supervisor has
/// fallen silent. The `known_loads` and `first_gains` are as Supervisor::create takes them.
Result<std::unique_ptr<participant::Application>> create_application(const robot::Robot& robot, Design design,
                                                                     participant::Participant& participant,
                                                                     Tick ticks, bool stands_by = false,
                                                                     std::vector<robot::LoadChange> known_loads = {},
                                                                     const std::vector<SlotGains>& first_gains = {});

}  // namespace farrier::supervisor
