#pragma once

#include <optional>

#include "core/phase.hpp"
#include "core/time.hpp"
#include "gait/schedule.hpp"
#include "locomotion/body_model.hpp"

namespace farrier::locomotion {

/// Phases of the legs for a gait that starts and stops on command. The pattern is gait::Schedule's; its ticks count from
/// the start. A leg lifts off only if the gait was still wanted at the announcement of that lift-off, so an announced
/// switch always happens. After stop() every leg finishes its swing and then stands.
class TrotSchedule {
 public:
  /// `plan` must pass gait::validate().
  explicit TrotSchedule(const gait::RobotPlan& plan);

  /// Starts stepping from a stand. Ignored while walking() is true. The first lift-off is half a stance later.
  void start(Tick now) noexcept;

  /// Lets no further leg lift off.
  void stop() noexcept { wanted_ = false; }

  /// Advances to tick `now`. Call once per tick.
  void step(Tick now) noexcept;

  /// True from start() until all legs stand after stop().
  bool walking() const noexcept { return walking_; }
  bool wanted() const noexcept { return wanted_; }

  Phase phase(int leg) const noexcept { return legs_[leg].phase; }

  /// Share of the stance that has passed, 0..1, 1/2 for a leg that stays; -1 in swing.
  double stance_progress(int leg) const noexcept { return legs_[leg].stance_progress; }

  /// Share of the swing that has passed, 0..1; -1 in stance.
  double swing_progress(int leg) const noexcept { return legs_[leg].swing_progress; }

  /// The switch announced at this tick, with its absolute tick.
  std::optional<gait::PhaseSwitch> announcement(int leg) const noexcept { return legs_[leg].announced; }

  double stance_s() const noexcept { return static_cast<double>(pattern_.stance_ticks()) * period_s_; }
  double swing_s() const noexcept {
    return static_cast<double>(pattern_.stride_ticks() - pattern_.stance_ticks()) * period_s_;
  }

 private:
  struct Leg {
    bool lifts = false;       // a lift-off is announced, or its swing is under way
    std::uint32_t count = 0;  // switches announced since construction
    Phase phase = Phase::kStance;
    double stance_progress = 0.5;
    double swing_progress = -1.0;
    std::optional<gait::PhaseSwitch> announced;
  };

  void announce(Leg& leg, int number, Tick pattern_tick) noexcept;
  void place(Leg& leg, int number, Tick pattern_tick) noexcept;

  gait::Schedule pattern_;
  double period_s_;
  int leg_count_;
  Tick origin_ = 0;  // tick at which the pattern began
  bool walking_ = false;
  bool wanted_ = false;
  PerLeg<Leg> legs_;
};

}  // namespace farrier::locomotion
