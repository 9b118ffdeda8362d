#pragma once

#include "robot/robot.hpp"
#include "signals/signals.hpp"

namespace farrier::joint_node {

/// Decides which of a joint's readings can be used, for the conditions of `sensors stale` and `force lost`. No
/// allocation.
class SensorCheck {
 public:
  SensorCheck(const robot::Joint& joint, const robot::Safety& safety) noexcept;

  struct Verdict {
    bool motion;  ///< position and velocity can be used; false without sensors
    bool force;
    int new_samples;  ///< since the last verdict: 0 or 1
  };

  /// Takes the newest sensors, once per control period.
  Verdict take(const signals::JointSensors& newest, double age_s) noexcept;

 private:
  bool reachable(const signals::JointSensors& now) const noexcept;
  bool position_in_range(const signals::JointSensors& sensors) const noexcept;

  double stroke_;
  double largest_force_;  ///< N or Nm
  robot::Safety safety_;
  int alike_ = 0;  ///< samples in a row, in every number
  signals::JointSensors last_;
};

}  // namespace farrier::joint_node
