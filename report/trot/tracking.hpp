#pragma once

// Tracking: how well the joints of a run were torque sources.

#include <cstdint>
#include <span>
#include <vector>

#include "gait/schedule.hpp"
#include "trace/trace.hpp"
#include "robot/robot.hpp"
#include "report/figures/figures.hpp"

namespace farrier::report {

/// Rated force of an actuator: the scale of its errors.
struct Rating {
  double force;  ///< N, or Nm for a rotary motor
  bool rotary;
};
Rating rating_of(const robot::Robot& robot, const robot::Joint& joint);

/// First tick that is judged: the start of the leg's third stride, for one that only stands 1 s after the lead-in.
Tick first_judged_tick(const robot::Robot& robot, const gait::Schedule& schedule, int leg);

/// Force error of one joint over the judged ticks of one phase, N or Nm.
struct PhaseError {
  std::uint64_t ticks = 0;
  double rms_error = 0.0;
  double rms_reference = 0.0;  ///< about its mean over these ticks
  double nrmse = 0.0;          ///< rms_error / max(rms_reference, 5 % of the rating); NaN without a tick
};

struct JointTracking {
  PhaseError stance, swing;        ///< planned phases, whichever gains act
  double travel_rad = 0.0;         ///< largest less smallest joint angle (m where the joint is a piston), judged ticks
  std::uint64_t missed_ticks = 0;  ///< judged ticks whose command is older than the loop delay
  std::uint64_t not_tracking_ticks = 0;  ///< judged ticks at null or damping: their reference is no reference
  bool tripped = false;                  ///< at any tick of the run
};

struct Tracking {
  std::vector<JointTracking> joints;  ///< in the order of Robot::joints
  int strides = 0;                    ///< completed by every leg; 0 for a robot that stands
  Tick ticks = 0;                     ///< of the run
};

/// True if every joint has judged ticks in every phase its gait has.
bool long_enough(const robot::Robot& robot, const Tracking& tracking);

/// Judges the rows, in any order, in one pass. Stance and swing are those that the schedule plans, for any gains and
/// any touchdown: runs that switch at different ticks are judged on the same ones. A row of a joint that the robot does
/// not have is a bug.
Tracking track(const robot::Robot& robot, const gait::Schedule& schedule, std::span<const trace::TraceRow> rows,
               int loop_delay_ticks);

/// Which figures of a run are judged: on the real-time clock the machine's scheduling decides them, and they are
/// measured only.
enum class Judgement { kLockstep, kMeasuredOnly };

/// Adds trot.ticks, trot.strides and each joint's figures. A joint that is its piston has no travel_rad. In lock-step
/// figures of a judged robot have bounds: stance NRMSE by its file, knees of a trot by kKneeTravel_rad, missed ticks
/// and ticks without tracking by 0. Tripped joints are bounded by 0 on either clock.
inline constexpr double kKneeTravel_rad = 0.3;
void add_tracking(Figures& figures, const robot::Robot& robot, const Tracking& tracking, Judgement judgement);

/// Adds the errors of a second run in which every joint kept its swing design: the benefit of adaptation.
void add_swing_design_tracking(Figures& figures, const robot::Robot& robot, const Tracking& tracking);

}  // namespace farrier::report
