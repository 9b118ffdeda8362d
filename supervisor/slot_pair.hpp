#pragma once

#include "control/design/lqr.hpp"
#include "control/design/measurement_filter.hpp"
#include "core/time.hpp"
#include "robot/robot.hpp"

namespace farrier::supervisor {

/// Distance of a loop from instability, as recorded in a decision.
struct LoopMargins {
  double disk;     ///< 0..2
  double delay_s;  ///< tolerated beyond the loop's own, at most kLongestDelay_s
};

/// Delays that no loop of a joint has: a loop that tolerates more is recorded with this.
inline constexpr double kLongestDelay_s = 1.0;

/// Margins of gains around the model they are designed for, control::margins(), with the filters of the joint's
/// sensors in the loop.
LoopMargins margins_of(const control::Gains& gains, double period_s,
                       const control::MeasurementFilters& filters) noexcept;

/// The same with the poles of that loop without filters, control::closed_loop_spectrum().
LoopMargins margins_of(const control::Gains& gains, double period_s, const control::MeasurementFilters& filters,
                       const control::SmallSpectrum& poles) noexcept;

/// True if they are at least disk_margin_min and delay_margin_min_s.
bool sufficient(const LoopMargins& margins, const robot::UpdateLogicParams& logic) noexcept;

/// Least number of ticks for which each of a joint's two loops must act before the other does, so that any number of
/// changes between them is stable. The loops are those of its slots' gains around their models. Returns 0 if the two
/// have a common quadratic Lyapunov function, control::kNoDwell if no bound was found.
int dwell_ticks(const control::Gains& one, const control::Gains& other) noexcept;

/// Least number of ticks for which a slot of a joint acts in the gait of the robot. Stance gains act stance_lead_s
/// before the planned touchdown, so they lengthen the stance and shorten the swing by it. On a ground a touchdown that is
/// felt may shorten the swing more (FeltTouchdownParams). A robot that stands does not change slots: control::kNoDwell.
int shortest_phase_ticks(const robot::Robot& robot) noexcept;

/// Constraints on the slot being redesigned.
struct SlotPair {
  const control::Gains& other;  ///< of the joint's other slot
  int shortest_phase_ticks;     ///< largest dwell time the gait allows; control::kNoDwell: it does not change slots
  bool dwelling;                ///< the joint's last gains must act for longer before it gets new ones
};

}  // namespace farrier::supervisor
