#pragma once

#include <memory>

#include "participant/application.hpp"
#include "participant/participant.hpp"
#include "robot/robot.hpp"

namespace farrier::estimator_service {

/// The service on its ports, on either clock. In lock-step a tick is finished when every joint's measurement of it has
/// come. In real time each measurement is taken as it comes. With `ticks` 0 it runs until told to stop.
Result<std::unique_ptr<participant::Application>> create_application(const robot::Robot& robot,
                                                                     participant::Participant& participant,
                                                                     Tick ticks);

}  // namespace farrier::estimator_service
