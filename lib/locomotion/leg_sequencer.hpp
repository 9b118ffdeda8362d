#pragma once

#include <Eigen/Core>

#include "locomotion/trot_schedule.hpp"

namespace farrier::locomotion {

/// Rules by which contacts with the ground overrule the schedule.
struct LegSequencerParams {
  double early_force_N = 40.0;  ///< a normal force above this is a contact in a swing, > 0
  double late_force_N = 20.0;   ///< the same after the swing, when the leg hardly accelerates, > 0
  double early_progress = 0.5;  ///< share of the swing from which on a contact ends it, 0..1
  double lost_speed_m_s = 2.0;  ///< a standing foot that falls faster has lost the ground, > 0
  double settle_s = 0.03;       ///< after a touchdown the contact counts as kept, >= 0
};

/// Action of a leg.
enum class LegAction {
  kStance,  ///< the foot is on the ground
  kSwing,   ///< the foot is on its path
  kReach,   ///< the path ended without a contact, or the ground gave way: the foot goes downwards
};

/// One leg's action, from its planned phase and its contact.
class LegSequencer {
 public:
  LegSequencer(const LegSequencerParams& params, double period_s) noexcept : params_(params), period_s_(period_s) {}

  /// Advances by one tick. `swing_progress` is the schedule's, -1 in stance. The force is that along the ground's normal
  /// (N), the velocity that of the foot along the normal (m/s, world frame).
  void step(double swing_progress, double normal_force_N, double normal_velocity_m_s) noexcept;

  LegAction action() const noexcept { return action_; }
  bool stands() const noexcept { return action_ == LegAction::kStance; }
  /// True at the tick in which the action began.
  bool lifted_off() const noexcept { return since_s_ == 0.0 && action_ == LegAction::kSwing; }
  bool lost() const noexcept { return since_s_ == 0.0 && action_ == LegAction::kReach; }
  /// Time since the action began, s. A leg that has stood since the start has stood forever.
  double since_s() const noexcept { return since_s_; }

 private:
  LegAction next(double swing_progress, double normal_force_N, double normal_velocity_m_s) noexcept;

  LegSequencerParams params_;
  double period_s_;
  LegAction action_ = LegAction::kStance;
  double since_s_ = 1e9;
  bool early_ = false;  // the present stance began before its plan
};

}  // namespace farrier::locomotion
