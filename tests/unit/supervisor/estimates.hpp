#pragma once

// Estimates of a joint's load as the update logic gets them.

#include <gtest/gtest.h>

#include "control/design/switching.hpp"
#include "robot/joint_model.hpp"
#include "supervisor/joint_design.hpp"
#include "supervisor/slot_update.hpp"
#include "tests/unit/robot/test_files.hpp"

namespace farrier::supervisor::testing {

inline constexpr int kNoDelay = 0;

inline const robot::Robot& rig() {
  static const robot::Robot robot = robot::load_shipped("fc1d");
  return robot;
}

inline const robot::Robot& hyq() {
  static const robot::Robot robot = robot::load_shipped("hyq");
  return robot;
}

/// The rig's cart with another mass.
inline plant::LoadParams cart(double mass_kg) {
  plant::LoadParams load = rig().joints[0].swing_load;
  load.mass = mass_kg;
  return load;
}

inline control::DiscreteModel model_of(const plant::LoadParams& load) {
  return robot::model_of(rig().joints[0], load, rig().period_s);
}

/// A load that runs away, and that neither valve nor force moves.
inline control::DiscreteModel unstabilisable() {
  control::DiscreteModel model = model_of(cart(20.0));
  model.a.row(1) << 0.0, 1.02, 0.0;
  model.b.head<2>().setZero();
  return model;
}

/// The update logic of the rig that believes an estimate over the stored model from the first.
inline robot::UpdateLogicParams credulous() {
  robot::UpdateLogicParams logic = rig().update_logic;
  logic.model_uncertainty = 1.0;
  return logic;
}

/// A sure estimate of `model`: valid, its valve gain known to a standard error of `relative_error`.
inline signals::JointModelEstimate estimate_of(const control::DiscreteModel& model, std::uint16_t joint = 0,
                                               signals::Phase phase = signals::Phase::kSwing,
                                               double relative_error = 0.0) {
  signals::JointModelEstimate estimate;
  estimate.joint = joint;
  estimate.phase = phase;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      estimate.a[static_cast<std::size_t>(3 * row + column)] = model.a(row, column);
    }
    estimate.b[static_cast<std::size_t>(row)] = model.b(row);
  }
  estimate.b_error[2] = relative_error * model.b(2);
  estimate.validity = 0.9;
  estimate.excitation = 1e-3;
  estimate.samples = 500;
  return estimate;
}

inline control::Gains gains_for(const plant::LoadParams& load) {
  return design_joint(rig().joints[0], load, rig().period_s, kNoDelay).value();
}

/// One slot of the rig whose gains are designed for a load.
inline SlotUpdate slot_for(const plant::LoadParams& load, const robot::UpdateLogicParams& logic = rig().update_logic) {
  const int period = rig().estimate_period_ticks;
  return SlotUpdate(rig().joints[0], logic, rig().period_s, period, gains_for(load));
}

/// Lets a slot of a robot that stands look at an estimate.
inline signals::JointUpdateDecision show(SlotUpdate& slot, const signals::JointModelEstimate& estimate, Tick tick) {
  return slot.look(estimate, tick, {slot.gains(), control::kNoDwell, false});
}

inline signals::UpdateVerdict verdict_of(const signals::JointUpdateDecision& decision) { return decision.verdict; }

/// Returns the decisions on the same estimate, shown until it is accepted or `looks` are over.
inline std::vector<signals::JointUpdateDecision> insist(SlotUpdate& slot, const signals::JointModelEstimate& estimate,
                                                        int looks) {
  std::vector<signals::JointUpdateDecision> decisions;
  for (int look = 0; look < looks; ++look) {
    decisions.push_back(show(slot, estimate, look * rig().estimate_period_ticks));
    if (verdict_of(decisions.back()) == signals::UpdateVerdict::kAccepted) {
      break;
    }
  }
  return decisions;
}

}  // namespace farrier::supervisor::testing
