#pragma once

// First gains of a joint's slots.

#include <array>
#include <vector>

#include "control/design/closed_loop.hpp"
#include "plant/joint_physics.hpp"
#include "robot/robot.hpp"
#include "signals/signals.hpp"

namespace farrier::supervisor {

using robot::Design;

/// Gains of a joint's slots, by phase.
using SlotGains = PerPhase<control::Gains>;

inline constexpr std::array kPhases{signals::Phase::kSwing, signals::Phase::kStance};

/// Gains of both slots of a joint. Refuses as design_joint does.
Result<SlotGains> design_slots(const robot::Joint& joint, Design design, double period_s, int delay_ticks);

/// Physics of the load that a slot's gains are for, except that adaptation begins with each phase's own.
plant::JointPhysics first_physics(const robot::Joint& joint, Design design, signals::Phase phase) noexcept;

/// Checks that given first gains, if not empty, are for the joints of the robot and this delay.
Result<Done> check_first(const robot::Robot& robot, const std::vector<SlotGains>& first_gains, int delay_ticks);

}  // namespace farrier::supervisor
