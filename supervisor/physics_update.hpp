#pragma once

// Decides about new physics for one slot of a joint with FlowInversion:
//
//   estimate ──▶ valid? ──▶ far from the acting physics, beyond errors? ──▶ short step settles on estimate and acting
//   physics? ──▶ accepted: physics and model are stored.
//
// The step is simulated on the estimate and on the acting physics within their uncertainty. FlowInversion inverts the
// flow law.

#include "control/model/discretise.hpp"
#include "plant/joint_physics.hpp"
#include "robot/robot.hpp"
#include "signals/signals.hpp"
#include "supervisor/law_check.hpp"
#include "supervisor/update_record.hpp"

namespace farrier::supervisor {

/// The update logic of one slot of such a joint. It needs no convergence and no dwell time: the issued physics are the
/// current knowledge of the joint, and the controller that takes them keeps its force through the change
/// (docs/decisions/0031-physics-updates.md). No clock, no I/O, no allocation.
class PhysicsUpdate {
 public:
  /// `first`: the physics the slot begins with. With new ones the law must settle on each of the `loads_to_hold` too.
  /// With `keeps_load` only valve and oil are taken from an estimate: on a ground the load behind the cell is not the
  /// joint's own.
  PhysicsUpdate(const robot::Joint& joint, const robot::UpdateLogicParams& logic, double period_s,
                int estimate_period_ticks, int loop_delay_ticks, const plant::JointPhysics& first,
                const std::vector<plant::LoadParams>& loads_to_hold = {}, bool keeps_load = false);

  /// Judges one estimate of the slot's phase. The decision is complete except for its generation. It has no poles or
  /// margins, because nothing here depends on them. After kAccepted physics() and model() are the new ones. A valve that
  /// counts as stronger (EstimateFlag::kCountsAsStronger) is accepted at once: a law for it is slower than the acting one.
  signals::JointUpdateDecision look(const signals::JointModelEstimate& estimate, Tick tick) noexcept;

  /// Adopts another supervisor's acting physics.
  void adopt(const plant::JointPhysics& physics, const control::DiscreteModel& model) noexcept;

  /// Marks the acting physics as unknown: the next valid estimate then counts as far from them at any distance.
  void doubt() noexcept { doubted_ = true; }

  const plant::JointPhysics& physics() const noexcept { return physics_; }

  /// Linear model of the last accepted estimate, SI; unit model before the first.
  const control::DiscreteModel& model() const noexcept { return model_; }

  /// True when the last decision is news: accepted, or refused for another reason than the one before.
  bool is_news() const noexcept { return news_.is_news(); }

 private:
  signals::UpdateVerdict judge(const signals::JointModelEstimate& estimate) noexcept;
  signals::UpdateVerdict calm(double valve_gain, const control::DiscreteModel& model) noexcept;
  bool differs(const signals::JointModelEstimate& estimate) const noexcept;
  plant::JointPhysics stored_towards(const plant::JointPhysics& estimated) const noexcept;
  double scale(std::size_t i) const noexcept;

  robot::UpdateLogicParams logic_;
  bool keeps_load_;
  LawCheck law_;
  std::array<double, plant::kPhysicsCount> least_scale_;  ///< of quantities that may be zero
  double estimate_period_s_;
  plant::JointPhysics physics_;
  std::vector<plant::JointPhysics> physics_to_hold_;
  control::DiscreteModel model_{};
  bool doubted_ = false;
  double contradicted_s_ = 0;  // for how long estimates have contradicted the stored physics
  UpdateNews news_;
};

}  // namespace farrier::supervisor
