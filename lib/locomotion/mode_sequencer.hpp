#pragma once

#include "locomotion/controller.hpp"
#include "locomotion/trot_schedule.hpp"
#include "locomotion/trunk_reference.hpp"

namespace farrier::locomotion {

/// Transitions between lying, standing and trotting.
struct ModeSequencerParams {
  double soft_start_s = 2.0;         ///< from the pose of the first tick to the folded one, > 0
  double take_load_s = 1.0;          ///< in which the weight goes from the pose to the feet or back, > 0
  double folded_height_m = 0.40;     ///< trunk's height at which a robot that sits down takes its pose, > 0
  double height_tolerance_m = 0.01;  ///< the reference counts as reached within this, > 0
  double settle_s = 1.0;             ///< stepping in place before a stop, >= 0
  double fallen_cosine = 0.5;        ///< cosine of the tilt from which on the robot counts as fallen, 60 degrees
};

using Mode = MotionMode;

/// Mode of the robot, and how the load is shared between pose control and forces at the feet.
class ModeSequencer {
 public:
  ModeSequencer(const ModeSequencerParams& params, double period_s) noexcept : params_(params), period_s_(period_s) {}

  /// Advances by one tick. `up` is the vertical component of the trunk's z axis.
  void step(Tick now, const MotionCommand& command, double up, const TrunkReference& reference,
            TrotSchedule& schedule) noexcept;

  /// Begins again with the soft start.
  void restart() noexcept { *this = ModeSequencer(params_, period_s_); }

  Mode mode() const noexcept { return mode_; }
  /// True in the tick in which the mode began.
  bool entered() const noexcept { return entered_; }
  /// Share of the weight that the feet carry by force control, 0..1. The rest is the pose's.
  double force_share() const noexcept { return force_share_; }
  /// Progress of the soft start, 0..1.
  double soft_start() const noexcept { return soft_start_; }
  /// True if the commanded velocity counts.
  bool moving() const noexcept { return mode_ == Mode::kTrot; }
  /// Height of the trunk that this mode asks for, m.
  double height_m(const MotionCommand& command, const TrunkReference& reference) const noexcept;
  /// True while all feet stand by plan.
  bool standing() const noexcept { return mode_ == Mode::kLie || mode_ == Mode::kStand; }

 private:
  Mode next(const MotionCommand& command, const TrunkReference& reference, const TrotSchedule& schedule) const noexcept;

  ModeSequencerParams params_;
  double period_s_;
  Mode mode_ = Mode::kLie;
  bool entered_ = true;
  double force_share_ = 0.0;
  double soft_start_ = 0.0;
  double rest_s_ = 0.0;  // since velocities are zero, in a stop
};

}  // namespace farrier::locomotion
