#pragma once

#include <string>

#include "control/design/closed_loop.hpp"
#include "control/law/feedback_linearisation.hpp"
#include "core/result.hpp"
#include "signals/signals.hpp"

namespace farrier::joint_node {

/// Decides whether gains that came over the wire may act on a joint whose controller is of this kind. All but
/// flow_inversion: every number finite, a delay the controller can hold,
/// scales and integral action positive, no position gain in the compliant form, and the closed loop stable for the
/// model they came with. Flow_inversion takes the physics alone: there, and in the ranges of plant::JointPhysics.
/// Refuses with the reason.
Result<Done> check_gains(const signals::JointControllerGains& signal, control::Kind kind);

}  // namespace farrier::joint_node
