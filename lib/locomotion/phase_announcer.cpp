#include "locomotion/phase_announcer.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::locomotion {

PhaseAnnouncer::PhaseAnnouncer(const FeltTouchdownParams& params, double period_s) noexcept
    : params_(params),
      debounce_ticks_(std::max<Tick>(1, std::llround(params.debounce_s / period_s))),
      least_swing_ticks_(std::llround(params.least_swing_s / period_s)),
      lead_ticks_(std::llround(params.stance_lead_s / period_s)) {}

bool PhaseAnnouncer::feels(Tick now, const Leg& leg) noexcept {
  if (leg.phase != Phase::kSwing) {
    pressed_ticks_ = 0;
    told_ = false;
    return false;
  }
  pressed_ticks_ = leg.stands && leg.normal_force_N > params_.force_N ? pressed_ticks_ + 1 : 0;
  const Tick next = now + 1;
  const bool stance_acts = touchdown_ > lift_off_ && next >= touchdown_ - lead_ticks_;
  return params_.on && !told_ && !stance_acts && pressed_ticks_ >= debounce_ticks_ &&
         next - lift_off_ >= least_swing_ticks_;
}

void PhaseAnnouncer::step(Tick now, const Leg& leg) noexcept {
  announcement_ = leg.planned;
  if (leg.planned) {
    (leg.planned->phase == Phase::kSwing ? lift_off_ : touchdown_) = leg.planned->tick;
  }
  const bool felt = feels(now, leg);
  if (felt && !announcement_) {
    told_ = true;
    announcement_ = gait::PhaseSwitch{.count = 0, .tick = now + 1, .phase = Phase::kStance, .felt = true};
  }
  if (announcement_) {
    announcement_->count = ++count_;
  }
}

}  // namespace farrier::locomotion
