#pragma once

// Work of adaptation in a run: which redesigns became gains.

#include "robot/robot.hpp"
#include "report/figures/figures.hpp"
#include "report/figures/run_info.hpp"

namespace farrier::report {

/// Redesigns that hips and knees must have in a run long enough to be judged: each of a leg's two loads is learnt at
/// least once, and one of them better.
inline constexpr double kUpdatesAtLeast = 3;
inline constexpr double kUpdatesJudgedFrom_s = 9.0;

/// Adds trot.<joint>.updates and .refused_designs and trot.updates. `judged`: the run adapts on the lock-step clock.
/// Bounds then apply to hips and knees that flex in a three-jointed leg of a judged robot that trots for `ticks` of at
/// least kUpdatesJudgedFrom_s. HAA see nearly one load in both phases, rigid drives need no other gains.
void add_updates(Figures& figures, const robot::Robot& robot, std::span<const DecisionInfo> decisions, Tick ticks,
                 bool judged);

/// "lf_kfe stance: accepted, generation 5, poles 0.21 from the designed, spread 0.013, validity 0.93": for people.
std::string decision_text(const DecisionInfo& decision);

}  // namespace farrier::report
