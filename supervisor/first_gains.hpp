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

/// Gains of both slots of a joint. Adaptation begins with the swing load's in both, and finds those of stance itself.
/// Behind filters an unstable loop grows too fast for that: there each phase begins with its own. Refuses as
/// design_joint does.
Result<SlotGains> design_slots(const robot::Joint& joint, Design design, double period_s, int delay_ticks);

/// Physics of the load that a slot's gains are for, except that adaptation begins with each phase's own.
plant::JointPhysics first_physics(const robot::Joint& joint, Design design, signals::Phase phase) noexcept;

/// Loads that a slot's gains must hold beside the estimated one: none on a bench without filters. Behind filters those of
/// the file, because an unstable loop grows there before an estimate can tell. On a ground those of the mass matrix,
/// because the estimated load is another joint's business too. A robot that stands must hold those of both phases: its
/// loads may change within its one phase.
std::vector<plant::LoadParams> loads_to_hold(const robot::Robot& robot, const robot::Joint& joint,
                                             signals::Phase phase);

/// Checks that given first gains, if not empty, are for the joints of the robot and this delay.
Result<Done> check_first(const robot::Robot& robot, const std::vector<SlotGains>& first_gains, int delay_ticks);

}  // namespace farrier::supervisor
