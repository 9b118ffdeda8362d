#pragma once

// What the robot may do, and with which gains:
//
//   tick ──▶ arm, publish the designed gains ──▶ system/mode, joint/controller_gains
//   joint/model_estimate ──▶ (redesign when it pays: not yet) ──▶ joint/update_decision

#include <string_view>
#include <vector>

#include "robot/load_change.hpp"
#include "robot/robot.hpp"
#include "signals/signals.hpp"

namespace farrier::supervisor {

/// Which bench load the published gains are designed for: one load for both slots of a joint, or each slot its own.
/// kAdaptive begins with the swing load in both, and stays there: nothing is redesigned yet.
enum class Design { kStance, kSwing, kPhases, kAdaptive };

/// "stance", "swing", "phases", "adaptive"; anything else counts as "stance".
Design parse_design(std::string_view name) noexcept;

/// Ticks from the publication of gains or a mode to the tick from which they act.
inline constexpr Tick kLeadTicks = 2;

/// The supervisor's core. No clock, no I/O; designs at construction, step only hands out.
class Supervisor {
 public:
  /// `known_loads` is perfect knowledge, to measure by: gains designed for that load go into both slots of the joint
  /// and act exactly from its tick on (never sooner than kLeadTicks after the first step). Refuses a robot with a joint
  /// that has no controller, with the reason.
  static Result<Supervisor> create(const robot::Robot& robot, Design design, int loop_delay_ticks,
                                   std::uint64_t session, std::vector<robot::LoadChange> known_loads = {});

  struct Outputs {
    std::vector<signals::JointControllerGains> gains;
    std::vector<signals::SystemMode> modes;
    std::vector<signals::JointUpdateDecision> decisions;  ///< none yet
  };

  /// What to publish at this tick: everything at the first, later the gains for known loads.
  const Outputs& step(Tick tick) noexcept;

  /// Takes an estimate; counts it. Nothing is redesigned from it yet.
  void take(const signals::JointModelEstimate& estimate) noexcept;

  std::uint64_t estimates() const noexcept { return estimates_; }

 private:
  struct Batch {
    Tick tick;  ///< of its issue; the first is issued at the first step
    Outputs outputs;
  };

  explicit Supervisor(std::vector<Batch> batches) : batches_(std::move(batches)) {}

  std::vector<Batch> batches_;  // in the order of their ticks
  std::size_t next_batch_ = 0;
  Outputs nothing_;
  std::uint64_t estimates_ = 0;
};

/// Gains as they travel. `generation` >= 1.
signals::JointControllerGains pack_gains(std::uint16_t joint, signals::Phase phase, std::uint32_t epoch,
                                         std::uint32_t generation, const control::Gains& gains) noexcept;

}  // namespace farrier::supervisor
