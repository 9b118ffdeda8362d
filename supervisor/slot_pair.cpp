#include "supervisor/slot_pair.hpp"

#include <algorithm>
#include <cmath>

#include "control/design/closed_loop.hpp"
#include "control/design/margins.hpp"
#include "control/design/switching.hpp"
#include "gait/schedule.hpp"

namespace farrier::supervisor {
namespace {

// A touchdown that is felt ends a swing from early_progress on, and not before least_swing_s.
Tick shortest_felt_swing(const robot::Robot& robot, Tick swing) noexcept {
  if (!robot.on_ground || !robot.locomotion || !robot.locomotion->felt_touchdown.on) {
    return swing;
  }
  const double early = robot.locomotion->contact.early_progress * static_cast<double>(swing);
  return std::max<Tick>(std::llround(robot.locomotion->felt_touchdown.least_swing_s / robot.period_s),
                        static_cast<Tick>(early));
}

}  // namespace

LoopMargins margins_of(const control::Gains& gains, double period_s,
                       const control::MeasurementFilters& filters) noexcept {
  return margins_of(gains, period_s, filters, control::closed_loop_spectrum(gains.model, gains, gains.delay_ticks));
}

LoopMargins margins_of(const control::Gains& gains, double period_s, const control::MeasurementFilters& filters,
                       const control::SmallSpectrum& poles) noexcept {
  const control::Margins margins = control::margins(gains.model, gains, gains.delay_ticks, filters, poles);
  return {margins.disk, std::min(margins.delay_ticks * period_s, kLongestDelay_s)};
}

bool sufficient(const LoopMargins& margins, const robot::UpdateLogicParams& logic) noexcept {
  return margins.disk >= logic.disk_margin_min && margins.delay_s >= logic.delay_margin_min_s;
}

int dwell_ticks(const control::Gains& one, const control::Gains& other) noexcept {
  const control::SwitchingVerdict verdict =
      control::switching_verdict(one.model, one, other.model, other, one.delay_ticks);
  return verdict.common ? 0 : verdict.dwell_ticks;
}

// Lift-offs are as planned; touchdowns, at which the load changes, lie within the jitter. Gains change at the plan's.
int shortest_phase_ticks(const robot::Robot& robot) noexcept {
  if (robot.plan.gait.pattern == gait::Pattern::kStand) {
    return control::kNoDwell;
  }
  const gait::PhaseTicks ticks = gait::phase_ticks(robot.plan);
  const Tick lead = std::llround(robot.safety.stance_lead_s / robot.period_s);
  const Tick whole = ticks.stride - ticks.stance;
  const Tick swing = std::min(whole - lead, shortest_felt_swing(robot, whole));
  return static_cast<int>(std::max<Tick>(std::min(ticks.stance, swing) - ticks.jitter, 0));
}

}  // namespace farrier::supervisor
