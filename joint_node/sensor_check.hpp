#pragma once

#include "robot/robot.hpp"
#include "signals/signals.hpp"

namespace farrier::joint_node {

/// Decides which of a joint's readings can be used: the conditions of the table in docs/architecture.md. No allocation.
class SensorCheck {
 public:
  SensorCheck(const robot::Joint& joint, const robot::Safety& safety) noexcept;

  struct Verdict {
    bool motion;  ///< position and velocity; false without sensors
    bool force;
  };

  /// Takes the newest sensors, once per control period. A bad reading becomes good again after Safety::recovery_samples
  /// new samples without a fault.
  Verdict take(const signals::JointSensors& newest, double age_s) noexcept;

 private:
  bool reachable(const signals::JointSensors& now) const noexcept;
  bool position_in_range(const signals::JointSensors& sensors) const noexcept;
  int counted(int good, bool is_good, int new_samples) const noexcept;

  double stroke_;
  double largest_force_;  ///< N or Nm
  robot::Safety safety_;
  int good_motion_;  ///< samples in a row, at most recovery_samples
  int good_force_;
  int alike_ = 0;    ///< in a row, in every number
  signals::JointSensors last_;
};

}  // namespace farrier::joint_node
