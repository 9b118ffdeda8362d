#pragma once

#include "locomotion/controller.hpp"
#include "locomotion/trot_controller.hpp"
#include "signals/signals.hpp"

namespace farrier::locomotion {

/// The sample of body/state for the state after tick `tick` under `command`.
signals::BodyState body_state_signal(const LocomotionState& state, const MotionCommand& command, Tick tick) noexcept;

/// False for a command with a number that is not finite, or an unknown request.
bool is_possible(const signals::BodyCommand& command) noexcept;

}  // namespace farrier::locomotion
