#pragma once

#include "control/law/flow_inversion.hpp"

namespace farrier::control {

/// Conditions of a trial of a FlowInversion loop.
struct FlowInversionTrial {
  const plant::ActuatorParams& actuator;  ///< passes plant::validate
  const FlowInversionGains& gains;
  double position;        ///< at the start, at rest and without force; m or rad from fully retracted
  double slack_position;  ///< of the load's spring, likewise
  double force_step;      ///< of the reference, from the first tick on, N or Nm; > 0
  double period_s;
  int delay_ticks;
};

inline constexpr int kTrialTicks = 40;
inline constexpr int kTrialJudgedTicks = 10;  ///< the last of them

/// RMS force error over the last kTrialJudgedTicks ticks of a step, over the step. The controller is given `told`, the
/// joint has `actual` (both in the ranges of JointPhysics). The result is below 1 for a loop that settles. It is of the
/// order of the actuator's force over the step for one that oscillates between its limits. Infinite if the motion is
/// not finite. Allocation-free; at most (9 + 2 delay_ticks) kTrialTicks runs of FlowModel::advance.
double trial_error(const FlowInversionTrial& trial, const plant::JointPhysics& told,
                   const plant::JointPhysics& actual) noexcept;

}  // namespace farrier::control
