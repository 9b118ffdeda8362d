#pragma once

#include <cstdint>
#include <optional>

#include "core/time.hpp"
#include "gait/schedule.hpp"

namespace farrier::locomotion {

/// Rule by which a touchdown that is felt changes the gains of a leg's joints before its plan does.
struct FeltTouchdownParams {
  bool on = true;               ///< false: gains follow the plan alone
  double force_N = 60.0;        ///< normal force of a touchdown, > 0
  double debounce_s = 0.003;    ///< time for which the force must stay above, >= 0
  double least_swing_s = 0.05;  ///< time for which the gains of swing act at least, >= 0
  double stance_lead_s = 0.0;   ///< from the gains of stance to a planned touchdown, as in the joints, >= 0
};

/// Changes of phase of one leg as its joints are told: those of the plan, and a touchdown that is felt before its plan.
/// The plan goes first if both come at one tick. A felt touchdown that comes after the gains of stance act is not told.
class PhaseAnnouncer {
 public:
  PhaseAnnouncer(const FeltTouchdownParams& params, double period_s) noexcept;

  /// The schedule and the contact of the leg at one tick.
  struct Leg {
    std::optional<gait::PhaseSwitch> planned;  ///< announced by the schedule at this tick
    Phase phase;                               ///< planned
    bool stands;                               ///< the controller commands a standing leg
    double normal_force_N;                     ///< felt along the ground's normal
  };
  /// Advances to tick `now`. Call once per tick.
  void step(Tick now, const Leg& leg) noexcept;

  /// The switch to tell at this tick. Counts run 1, 2, ... over both kinds. A felt one begins with the next tick.
  const std::optional<gait::PhaseSwitch>& announcement() const noexcept { return announcement_; }

 private:
  bool feels(Tick now, const Leg& leg) noexcept;

  FeltTouchdownParams params_;
  Tick debounce_ticks_, least_swing_ticks_, lead_ticks_;
  std::uint32_t count_ = 0;
  Tick lift_off_ = kNoTick;   // newest announced
  Tick touchdown_ = kNoTick;  // newest announced
  Tick pressed_ticks_ = 0;    // the force has stayed above for so long
  bool told_ = false;         // the touchdown of this swing was felt and told
  std::optional<gait::PhaseSwitch> announcement_;
};

}  // namespace farrier::locomotion
