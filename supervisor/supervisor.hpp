#pragma once

// Controls the robot's mode and gains:
//
//   tick ──▶ arm, publish the first gains ──▶ system/mode, joint/controller_gains
//   joint/model_estimate ──▶ SlotUpdate or PhysicsUpdate of the joint's phase ──▶ joint/controller_gains, joint/update_decision

#include <array>
#include <optional>
#include <vector>

#include "robot/load_change.hpp"
#include "robot/robot.hpp"
#include "signals/signals.hpp"
#include "supervisor/first_gains.hpp"
#include "supervisor/physics_update.hpp"
#include "supervisor/slot_update.hpp"

namespace farrier::supervisor {

/// The supervisor's core. No clock, no I/O; nothing is allocated after construction.
class Supervisor {
 public:
  /// The `known_loads` are perfect knowledge, for baselines: gains designed for that load go into both slots of the
  /// joint and act exactly from its tick on (never sooner than gain_lead_ticks after the first step). The
  /// `first_gains`, by joint, replace the designs for bench loads in the slots; empty: those designs. Refuses a robot
  /// with a joint that has no controller. Also refuses first gains that are not for these joints or this delay, with
  /// the reason.
  static Result<Supervisor> create(const robot::Robot& robot, Design design, int loop_delay_ticks,
                                   std::uint64_t session, std::vector<robot::LoadChange> known_loads = {},
                                   const std::vector<SlotGains>& first_gains = {});

  struct Outputs {
    std::vector<signals::JointControllerGains> gains;
    std::vector<signals::SystemMode> modes;
    /// Gains accepted, and designs refused for a new reason; with the first gains, the bounds that these miss.
    std::vector<signals::JointUpdateDecision> decisions;
    std::vector<control::DesignStatus> design_statuses;  ///< of the decisions, in their order

    void clear() noexcept;
  };

  /// Outputs to publish at this tick: at the first everything; later the gains for known loads, and the results of the
  /// estimates taken since the last step.
  const Outputs& step(Tick tick) noexcept;

  /// Judges an estimate. Between two steps at most one estimate of a joint counts.
  void take(const signals::JointModelEstimate& estimate, Tick tick) noexcept;

  /// Arms or stops the robot as an operator asks, with the next step's mode; requests of other sessions are ignored.
  void take(const signals::SystemRequest& request) noexcept;

  /// Adopts the orders of the leading supervisor, to continue from them.
  void mirror(const signals::JointControllerGains& gains) noexcept;
  void mirror(const signals::SystemMode& mode) noexcept;

  /// Leads from now on under `authority`, with modes after `mode_epoch`. Nothing is issued for the change: acting
  /// orders keep acting. The next good estimate leads to new gains for a slot whose gains are not known.
  void take_over(std::uint32_t authority, std::uint32_t mode_epoch, Tick tick) noexcept;

  /// Leads no longer, and knows no acting order until it is mirrored.
  void stand_down() noexcept;

  /// Every order known to act: gains of all slots and the mode, under this supervisor's authority.
  const Outputs& orders() noexcept;

  /// Controllers designed from estimates so far, accepted or not.
  std::uint64_t designs() const noexcept;

 private:
  struct Batch {
    Tick tick;  ///< of its issue; the first is issued at the first step
    Outputs outputs;
  };
  struct JointSlots {
    PerPhase<SlotUpdate> slots;                      // by phase
    std::optional<PerPhase<PhysicsUpdate>> physics;  // decides in their place where there
    PerPhase<std::uint32_t> generations;
    PerPhase<plant::JointPhysics> first_physics;
    std::uint32_t newest_generation;
    int dwell_ticks;  // of the pair of slots
    Tick last_issue = 0;
    bool looked = false;  // true if an estimate was judged since the last step
  };

  Supervisor(std::vector<Batch> batches, std::vector<JointSlots> joints, std::size_t joint_count, int lead_ticks,
             int shortest_phase_ticks, std::uint64_t session);

  void take_gains(JointSlots& joint, const signals::JointModelEstimate& estimate, Tick tick) noexcept;
  void take_physics(JointSlots& joint, const signals::JointModelEstimate& estimate, Tick tick) noexcept;
  void remember(const Outputs& issued) noexcept;
  void issue(JointSlots& joint, signals::JointControllerGains gains) noexcept;
  void tell(const JointSlots& joint, signals::JointUpdateDecision decision, control::DesignStatus status) noexcept;

  std::vector<Batch> batches_;  // in the order of their ticks
  std::size_t next_batch_ = 0;
  std::vector<JointSlots> joints_;  // by number; empty unless adaptive
  Tick lead_ticks_;
  int shortest_phase_ticks_;
  std::uint64_t session_;
  std::uint32_t authority_;
  std::uint32_t epoch_;  // of the newest mode
  std::vector<signals::JointControllerGains>
      known_gains_;                 // that act, joint by joint and phase by phase; generation 0: not known
  signals::SystemMode known_mode_;  // epoch 0: not known
  Outputs orders_;
  Outputs pending_;  // results of estimates and requests
  Outputs issued_;
};

}  // namespace farrier::supervisor
