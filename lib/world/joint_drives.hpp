#pragma once

#include "body/model/body_state.hpp"

namespace farrier::world {

/// Drives of a body's joints within a tick. Each step of the body holds their torques; then they follow its motion.
class JointDrives {
 public:
  virtual ~JointDrives();

  /// At the present state, one per joint of the body.
  virtual const body::JointVector& torques_Nm() const noexcept = 0;
  /// The body has moved to `state` in a step of `step_s`.
  virtual void follow(const body::BodyState& state, double step_s) noexcept = 0;

 protected:
  JointDrives() = default;
  JointDrives(const JointDrives&) = default;
  JointDrives(JointDrives&&) = default;
  JointDrives& operator=(const JointDrives&) = default;
  JointDrives& operator=(JointDrives&&) = default;
};

}  // namespace farrier::world
