#pragma once

// Decides about new gains for one slot:
//
//   estimate ──▶ poles ──▶ valid? ──▶ method asks for new gains? ──▶ LQR ──▶ method lets them act?
//            ──▶ stable on estimate and stored model? ──▶ margins? ──▶ dwell time?
//            ──▶ accepted: gains and model are stored.
//
// A slot is a joint in one phase (Hubacher 2014, 8.2.1, Fig. 8.8, F.2). The stored model is tested within its
// uncertainty.

#include <optional>
#include <vector>

#include "control/design/lqr.hpp"
#include "robot/robot.hpp"
#include "signals/signals.hpp"
#include "supervisor/law_check.hpp"
#include "supervisor/slot_pair.hpp"
#include "supervisor/update_method.hpp"
#include "supervisor/update_record.hpp"

namespace farrier::supervisor {

/// The update logic of one slot, by the method that the robot file names. No clock, no I/O, no allocation.
class SlotUpdate {
 public:
  /// The slot begins with the gains `first`, with the model they are designed for. New gains must hold the joint on
  /// each of the `loads_to_hold` too. With `misfit_is_common` an estimate under misfit needs the full validity: on a
  /// ground the model never fits, because the load is another joint's business.
  SlotUpdate(const robot::Joint& joint, const robot::UpdateLogicParams& logic, double period_s,
             int estimate_period_ticks, const control::Gains& first,
             const std::vector<plant::LoadParams>& loads_to_hold = {}, bool misfit_is_common = false);

  /// Judges one estimate of the slot's phase; new gains must fit `pair`. The decision is complete except for its
  /// generation. After kAccepted gains() are the new ones.
  signals::JointUpdateDecision look(const signals::JointModelEstimate& estimate, Tick tick,
                                    const SlotPair& pair) noexcept;

  /// Adopts another supervisor's acting gains.
  void adopt(const control::Gains& gains) noexcept;

  /// Marks the acting gains as unknown: the next good estimate then leads to new ones at any distance.
  void doubt() noexcept { doubted_ = true; }

  /// Last accepted gains, and the model they are designed for.
  const control::Gains& gains() const noexcept { return gains_; }

  /// Controllers designed so far, accepted or not.
  std::uint64_t designs() const noexcept { return designs_; }

  /// Status of the last design: the name of its refusal, or kSuccessful.
  control::DesignStatus design_status() const noexcept { return design_status_; }

  /// True when the last decision is news: accepted, or refused for another reason than the one before.
  bool is_news() const noexcept { return news_.is_news(); }

 private:
  signals::UpdateVerdict judge(const signals::JointModelEstimate& estimate, const control::DiscreteModel& model,
                               const SlotPair& pair, signals::JointUpdateDecision& decision) noexcept;
  signals::UpdateVerdict redesign(const control::DiscreteModel& cautious, const control::DiscreteModel& model,
                                  const SlotPair& pair, signals::JointUpdateDecision& decision) noexcept;
  signals::UpdateVerdict hold(const control::Gains& gains, const control::SmallSpectrum& poles, const SlotPair& pair,
                              signals::JointUpdateDecision& decision) const noexcept;
  control::DiscreteModel stored_towards(const control::DiscreteModel& model) const noexcept;

  control::DesignRule rule_;
  control::Normalisation normalisation_;
  control::Form form_;
  robot::UpdateLogicParams logic_;
  control::MeasurementFilters filters_;
  double period_s_, estimate_period_s_;
  Method method_;
  control::Gains gains_;
  PoleSet designed_poles_;
  double misfit_leniency_;
  std::optional<LawCheck> law_;  // where there are loads to hold
  std::vector<plant::JointPhysics> physics_to_hold_;
  bool doubted_ = false;
  double contradicted_s_ = 0;  // for how long estimates have contradicted the stored model
  std::uint64_t designs_ = 0;
  control::DesignStatus design_status_ = control::DesignStatus::kSuccessful;
  UpdateNews news_;
};

}  // namespace farrier::supervisor
