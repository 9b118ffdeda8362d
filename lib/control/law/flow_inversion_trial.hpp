#pragma once

#include "control/law/flow_inversion.hpp"

namespace farrier::control {

/// What a loop of FlowInversion is tried on.
struct FlowInversionTrial {
  const plant::ActuatorParams& actuator;  ///< passes plant::validate
  const FlowInversionGains& gains;
  double position;        ///< at which it begins, at rest and without force; m or rad from fully retracted
  double slack_position;  ///< of the load's spring, likewise
  double force_step;      ///< asked for from the first tick on, N or Nm; > 0
  double period_s;
  int delay_ticks;
};

inline constexpr int kTrialTicks = 40;
inline constexpr int kTrialJudgedTicks = 10;  ///< the last of them

/// RMS force error over the last kTrialJudgedTicks ticks of a step, over the step, of a controller that is told `told`
/// on a joint that has `actual` (both in the ranges of JointPhysics): below 1 for a loop that settles, of the order of
/// the actuator's force over the step for one that oscillates between its limits. Infinite when the motion is not
/// finite. Allocation-free; at most (9 + 2 delay_ticks) kTrialTicks runs of FlowModel::advance.
double trial_error(const FlowInversionTrial& trial, const plant::JointPhysics& told,
                   const plant::JointPhysics& actual) noexcept;

}  // namespace farrier::control
