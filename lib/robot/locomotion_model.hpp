#pragma once

#include "body/dynamics/rigid_body.hpp"
#include "core/result.hpp"
#include "locomotion/body_model.hpp"

namespace farrier::robot {

/// The rigid bodies of a robot file, as controllers of the whole robot see them: lib/body behind locomotion's interface.
/// One thread uses a model at a time.
class LocomotionModel final : public locomotion::BodyModel {
 public:
  /// Refuses a body that RigidBody refuses.
  static Result<LocomotionModel> create(const body::BodyModel& model);

  int leg_count() const noexcept override { return body_.legs(); }
  double mass_kg() const noexcept override { return body_.total_mass_kg(); }

  /// The bias torques contain the viscous friction of the joints, as RigidBody's do not.
  /// Gravity has the size that the robot file gives; `trunk` gives its direction. Vectors that are zero or not finite
  /// make the results NaN.
  void update(std::span<const locomotion::LegReadings> legs, const locomotion::TrunkMotion& trunk,
              locomotion::BodyState& state) const noexcept override;

 private:
  LocomotionModel(const body::RigidBody& body, const body::JointVector& damping_Nms_rad)
      : damping_Nms_rad_(damping_Nms_rad), body_(body), moved_(body::BodyState::zero(body.joints())) {}

  body::JointVector damping_Nms_rad_;  // of the joints, viscous
  // Each update() sets both, whatever they were.
  mutable body::RigidBody body_;
  mutable body::BodyState moved_;
};

}  // namespace farrier::robot
