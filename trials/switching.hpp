#pragma once

#include <span>
#include <vector>

#include "trace/trace.hpp"
#include "robot/robot.hpp"
#include "signals/signals.hpp"
#include "supervisor/supervisor.hpp"

namespace farrier::trials {

inline constexpr double kTouchdownWindow_s = 0.030;

/// Force errors right after touchdowns.
struct TouchdownErrors {
  std::vector<double> integral_Ns;  ///< by joint; Nms for a motor; 0 for joints that do not flex
  int touchdowns = 0;               ///< of the leg that was judged least often
};

/// Integral of |F_ref - F| dt over kTouchdownWindow_s from each actual touchdown (where the simulated leg lands, not
/// where it was announced) at or after `from`, hips and knees of every leg. A window the rows do not cover is left out.
TouchdownErrors touchdown_errors(const robot::Robot& robot, std::span<const trace::TraceRow> rows, Tick from);

/// Returns the last gains issued for each slot, by joint. `gains` of a whole run, in the order of their issue.
std::vector<supervisor::SlotGains> last_gains(const robot::Robot& robot,
                                              std::span<const signals::JointControllerGains> gains);

/// The gains of one phase in both slots of every joint.
std::vector<supervisor::SlotGains> in_both_slots(std::vector<supervisor::SlotGains> gains, signals::Phase phase);

/// Largest jump of the valve command at a change of gains, reference and measurement unchanged, over the valve's
/// nominal current. Each joint's force controller is replayed on the trace with the gains that were issued. Whenever
/// other gains begin to act, a copy of the controller takes them and steps on the inputs of the last step. Dither is no
/// part of the replay. NaN if the trace names gains that were not issued.
double largest_bump(const robot::Robot& robot, std::span<const trace::TraceRow> rows,
                    std::span<const signals::JointControllerGains> gains);

}  // namespace farrier::trials
