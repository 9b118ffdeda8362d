#pragma once

#include "control/design/lqr.hpp"
#include "control/design/measurement_filter.hpp"
#include "plant/joint_physics.hpp"
#include "robot/robot.hpp"

namespace farrier::supervisor {

/// Finds by simulation whether the law of a hydraulic joint settles a small step of its command. The loop has the
/// filters of the joint's sensors, its delay and the joint's outer loop of stiffness and damping. Allocates nothing after
/// construction.
class LawCheck {
 public:
  LawCheck(const robot::Joint& joint, double period_s, int delay_ticks);

  /// True if the joint's own kind of law settles on a joint with the physics `actual`. A law of kind flow_inversion
  /// or feedback_linearisation is given the physics `told`. A joint of kind lqr has a linear design, and an electric one too: they always pass.
  bool settles(const plant::JointPhysics& told, const plant::JointPhysics& actual) const noexcept;

  /// True if the gains settle on a joint with these physics.
  bool settles(const control::Gains& gains, const plant::JointPhysics& actual) const noexcept;

 private:
  template <class Law>
  bool runs(Law law, int ticks, const plant::JointPhysics& actual) const noexcept;

  robot::Joint joint_;
  control::MeasurementFilters sensors_;
  control::MeasurementFilters filters_;
  double home_position_;
  double slack_position_;
  double lever_;
  double period_s_;
  int delay_ticks_;
};

}  // namespace farrier::supervisor
