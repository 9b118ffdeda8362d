#pragma once

#include "control/design/closed_loop.hpp"
#include "robot/robot.hpp"
#include "report/figures/figures.hpp"

namespace farrier::report {

/// Closed-loop poles of one joint at its home pose, for the loads and the loop delay of its robot.
struct JointPoles {
  control::ClosedLoopPoles stance_on_stance;  ///< stance design, stance load: what acts in stance
  control::ClosedLoopPoles stance_on_swing;   ///< stance design, swing load: a lift-off that was not foreseen
  control::ClosedLoopPoles swing_on_stance;   ///< swing design, stance load: a touchdown that was not foreseen
  // Spectral radii leave out the free position of the compliant form, as control::closed_loop_spectral_radius says.
  double stance_spectral_radius;  ///< stance design on the stance load
  double swing_spectral_radius;   ///< swing design on the swing load
  double stance_on_swing_spectral_radius;
  double swing_on_stance_spectral_radius;
};

/// Refuses a joint no controller can be designed for, with its name and the reason.
Result<JointPoles> joint_poles(const robot::Joint& joint, double period_s, int loop_delay_ticks);

/// Adds trot.<joint>.*_spectral_radius, which must be below 1. Refuses as joint_poles does.
Result<Done> add_spectral_radii(Figures& figures, const robot::Robot& robot, int loop_delay_ticks);

}  // namespace farrier::report
