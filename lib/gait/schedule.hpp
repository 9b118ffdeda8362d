#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/noise.hpp"
#include "core/time.hpp"
#include "core/phase.hpp"
#include "gait/gait_params.hpp"

namespace farrier::gait {

using farrier::Phase;

/// A change of phase of one leg. Counts run 1, 2, ...: of a schedule odd ones are lift-offs, even ones touchdowns.
struct PhaseSwitch {
  std::uint32_t count;
  Tick tick;          ///< planned, or of a touchdown that was felt
  Phase phase;        ///< that begins with this tick
  bool felt = false;  ///< a touchdown that was felt before its plan
};

/// Phases of the legs by tick: pure functions of the tick, the same on every machine. Stride, stance and offsets are
/// rounded to ticks once, so the pattern repeats exactly every stride_ticks().
///
/// All legs stand from tick 0. The leg with the largest phase offset lifts off first, half a stance after the lead-in;
/// the others follow at their offsets. Ticks before 0 count as 0.
class Schedule {
 public:
  /// `plan` must pass validate(). The seed shapes the touchdown jitter only, never the plan.
  Schedule(const RobotPlan& plan, std::uint64_t seed);

  /// Planned phase.
  Phase phase(int leg, Tick tick) const noexcept;

  /// Planned share of the stance that has passed, 0..1, at 1/2 during a long stand; -1 in swing. The first stance goes
  /// from 0 to 1/2 over the lead-in and stays there until the last half stance before the first lift-off.
  double stance_progress(int leg, Tick tick) const noexcept;

  /// Planned share of the swing that has passed, 0..1; -1 in stance.
  double swing_progress(int leg, Tick tick) const noexcept;

  /// Phase and progress with the actual touchdowns; lift-offs are as planned.
  Phase actual_phase(int leg, Tick tick) const noexcept;
  double actual_stance_progress(int leg, Tick tick) const noexcept;

  /// The switch to announce at exactly this tick: the one planned announce_ticks later, and at tick 0 also one planned
  /// sooner. Each switch is announced once, in order of its count.
  std::optional<PhaseSwitch> announcement(int leg, Tick now) const noexcept;

  /// Actual tick of the announced switch: touchdowns within +- jitter_ticks() of the plan, drawn from the seed, the
  /// leg's name and the count.
  Tick actual_switch(int leg, const PhaseSwitch& planned) const noexcept;

  /// Strides begin with a touchdown: 0, 1, ...; -1 before the leg's first.
  int stride(int leg, Tick tick) const noexcept;

  /// Ticks since the planned touchdown that began this stride, 0..stride_ticks() - 1. In the first stance, which no
  /// touchdown began, they count from where the pattern would have put one: negative until then, and unbounded for a
  /// robot that stands.
  Tick ticks_since_touchdown(int leg, Tick tick) const noexcept;

  Tick stride_ticks() const noexcept { return stride_; }
  Tick stance_ticks() const noexcept { return stance_; }
  Tick lead_in_ticks() const noexcept { return lead_in_; }
  Tick jitter_ticks() const noexcept { return jitter_; }

 private:
  struct Leg {
    Tick origin;         // tick at which the pattern would have put the touchdown before the first lift-off
    NoiseStream jitter;  // by count
  };

  Tick since_origin(int leg, Tick tick) const noexcept;
  bool standing(Tick since_origin) const noexcept { return always_stand_ || since_origin < stance_; }
  double standing_progress(int leg, Tick tick) const noexcept;
  Tick touchdown_shift(int leg, std::int64_t stride) const noexcept;

  Tick stride_ = 0, stance_ = 0, lead_in_ = 0, jitter_ = 0, announce_ = 0;
  bool always_stand_ = false;
  std::vector<Leg> legs_;
};

/// Ticks of the plan's phases, as Schedule rounds them.
struct PhaseTicks {
  Tick stride, stance, lead_in, jitter;
};
PhaseTicks phase_ticks(const RobotPlan& plan) noexcept;

}  // namespace farrier::gait
