#include "locomotion/trot_schedule.hpp"

namespace farrier::locomotion {
namespace {

constexpr std::uint64_t kNoJitter = 0;  // the seed shapes the touchdown jitter only, which locomotion does not use

}  // namespace

TrotSchedule::TrotSchedule(const gait::RobotPlan& plan)
    : pattern_(plan, kNoJitter), period_s_(plan.period_s), leg_count_(static_cast<int>(plan.legs.size())) {
  FARRIER_ENSURE(leg_count_ >= 1 && leg_count_ <= kMaxLegs, "locomotion has room for six legs");
}

void TrotSchedule::start(Tick now) noexcept {
  wanted_ = true;
  if (!walking_) {
    walking_ = true;
    origin_ = now - pattern_.lead_in_ticks();  // the robot stands already
  }
}

void TrotSchedule::step(Tick now) noexcept {
  bool any_steps = wanted_;
  for (int i = 0; i < leg_count_; ++i) {
    Leg& leg = legs_[i];
    leg.announced.reset();
    if (walking_) {
      announce(leg, i, now - origin_);
    }
    place(leg, i, now - origin_);
    any_steps = any_steps || leg.lifts;
  }
  walking_ = walking_ && any_steps;
}

void TrotSchedule::announce(Leg& leg, int number, Tick pattern_tick) noexcept {
  std::optional<gait::PhaseSwitch> next = pattern_.announcement(number, pattern_tick);
  if (!next) {
    return;
  }
  if (next->phase == Phase::kSwing) {
    leg.lifts = wanted_;
  }
  if (leg.lifts) {
    next->count = ++leg.count;
    next->tick += origin_;
    leg.announced = next;
  }
}

void TrotSchedule::place(Leg& leg, int number, Tick pattern_tick) noexcept {
  const bool was_swing = leg.phase == Phase::kSwing;
  const bool swings = walking_ && leg.lifts && pattern_.phase(number, pattern_tick) == Phase::kSwing;
  leg.phase = swings ? Phase::kSwing : Phase::kStance;
  leg.swing_progress = swings ? pattern_.swing_progress(number, pattern_tick) : -1.0;
  if (was_swing && !swings) {
    leg.lifts = false;  // until its next lift-off is announced
  }
  // A leg that stays stands in the middle of its stance. It joins the pattern's progress at half of it.
  const double planned = walking_ ? pattern_.stance_progress(number, pattern_tick) : -1.0;
  const bool ends_here = !leg.lifts && !wanted_;
  leg.stance_progress = swings ? -1.0 : (planned < 0.0 || (ends_here && planned > 0.5) ? 0.5 : planned);
}

}  // namespace farrier::locomotion
