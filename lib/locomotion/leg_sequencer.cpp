#include "locomotion/leg_sequencer.hpp"

namespace farrier::locomotion {

LegAction LegSequencer::next(double swing_progress, double force_N, double velocity_m_s) noexcept {
  const bool planned_swing = swing_progress >= 0.0;
  const bool contact = force_N > (planned_swing ? params_.early_force_N : params_.late_force_N);
  switch (action_) {
    case LegAction::kStance:
      if (!planned_swing) {
        early_ = false;
      } else if (!early_) {
        return LegAction::kSwing;
      }
      return since_s_ > params_.settle_s && velocity_m_s < -params_.lost_speed_m_s ? LegAction::kReach
                                                                                   : LegAction::kStance;
    case LegAction::kSwing:
      if (!planned_swing) {
        return contact ? LegAction::kStance : LegAction::kReach;
      }
      early_ = contact && swing_progress > params_.early_progress;
      return early_ ? LegAction::kStance : LegAction::kSwing;
    case LegAction::kReach:
      if (contact) {
        early_ = planned_swing;
        return LegAction::kStance;
      }
      return planned_swing && !early_ ? LegAction::kSwing : LegAction::kReach;
  }
  return action_;
}

void LegSequencer::step(double swing_progress, double normal_force_N, double normal_velocity_m_s) noexcept {
  const LegAction before = action_;
  action_ = next(swing_progress, normal_force_N, normal_velocity_m_s);
  since_s_ = action_ == before ? since_s_ + period_s_ : 0.0;
}

}  // namespace farrier::locomotion
