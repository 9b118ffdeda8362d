#pragma once

// Whether an estimate leads to new gains for one slot: a joint in one phase (Hubacher 2014, 8.2.1, Fig. 8.8, F.2):
//
//   estimate ──▶ poles ──▶ valid? ──▶ far from those designed for? ──▶ converged? ──▶ LQR ──▶ stable on the estimate
//            ──▶ and on the stored model within its uncertainty? ──▶ accepted: gains and model are stored

#include <complex>
#include <span>

#include "control/lqr.hpp"
#include "robot/robot.hpp"
#include "signals/signals.hpp"

namespace farrier::supervisor {

/// Update logic (d) of section 5.3 for one slot. No clock, no I/O, no allocation.
class SlotUpdate {
 public:
  /// `first`: the gains the slot begins with, with the model they are designed for.
  SlotUpdate(const robot::Joint& joint, const robot::UpdateLogicParams& logic, double estimate_period_s,
             int estimate_period_ticks, const control::Gains& first);

  /// Looks at one estimate of the slot's phase. The decision is complete but for its generation. kAccepted: gains()
  /// are the new ones.
  signals::JointUpdateDecision look(const signals::JointModelEstimate& estimate, Tick tick) noexcept;

  /// Last accepted gains, and the model they are designed for.
  const control::Gains& gains() const noexcept { return gains_; }

  /// Why the last design was refused by name, kSuccessful when it was not.
  control::DesignStatus design_status() const noexcept { return design_status_; }

  /// True when the last decision is news: accepted, or refused for another reason than the one before.
  bool is_news() const noexcept { return is_news_; }

 private:
  using PoleSet = std::array<std::complex<double>, 3>;  // two, and zero, for the compliant form: position is free there

  PoleSet poles_of(const control::DiscreteModel& model) const noexcept;
  double distance(const PoleSet& a, const PoleSet& b) const noexcept;
  void follow(const PoleSet& poles) noexcept;
  signals::UpdateVerdict judge(const signals::JointModelEstimate& estimate, const control::DiscreteModel& model,
                               signals::JointUpdateDecision& decision) noexcept;
  signals::UpdateVerdict redesign(const control::DiscreteModel& cautious, const control::DiscreteModel& model,
                                  signals::JointUpdateDecision& decision) noexcept;
  control::DiscreteModel stored_towards(const control::DiscreteModel& model) const noexcept;

  control::DesignRule rule_;
  control::Normalisation normalisation_;
  control::Form form_;
  robot::UpdateLogicParams logic_;
  double period_s_;
  double estimate_period_s_;
  int estimate_period_ticks_;
  control::Gains gains_;
  PoleSet designed_poles_;
  PoleSet anchor_{};             // where the poles were when they began to count as still
  double spread_ = 0;            // how far they have been from there
  int still_ticks_ = -1;         // for how long; -1: no anchor
  double contradicted_s_ = 0;    // for how long estimates have asked for what the stored model forbids
  control::DesignStatus design_status_ = control::DesignStatus::kSuccessful;
  signals::UpdateVerdict last_refusal_ = signals::UpdateVerdict::kAccepted;
  bool is_news_ = false;
};

}  // namespace farrier::supervisor
