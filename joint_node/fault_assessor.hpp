#pragma once

#include <array>

#include "core/fault.hpp"
#include "joint_node/sensor_check.hpp"
#include "robot/robot.hpp"
#include "signals/signals.hpp"

namespace farrier::joint_node {

/// Everything that the conditions of a joint's faults depend on, in one tick.
struct Situation {
  const robot::Joint& joint;
  const robot::Safety& limits;
  const signals::SystemMode& mode;       ///< in effect
  const signals::JointSensors& sensors;  ///< the newest available
  const signals::JointCommand& command;  ///< the newest available
  double command_age_s;                  ///< since an undelayed one would have arrived; infinite for none
  double since_last_step_s;              ///< 0 for the first
  SensorCheck::Verdict readings;         ///< of the sensors
  bool has_gains;                        ///< for the acting phase
  bool gains_refused;                    ///< the last gains of a phase

  bool armed() const noexcept;
};

/// Runs the safety table (core/fault.hpp): conditions of a tick in, faults with their latch and debounce out.
class FaultAssessor {
 public:
  explicit FaultAssessor(const robot::Safety& limits) noexcept { good_samples_.fill(limits.recovery_samples); }

  /// Sets and clears the faults that have a condition. `kReferenceClamped` and `kValveSaturated` follow in the same
  /// tick, from the reference and from the current.
  void assess(const Situation& now, FaultSet& faults) noexcept;

 private:
  std::array<int, kFaults.size()> good_samples_{};             ///< in a row, at most Safety::recovery_samples
  std::array<std::uint32_t, kFaults.size()> latched_epoch_{};  ///< of the mode in which the fault began
};

/// State of a joint with this output.
signals::JointState state_of(SafeOutput output) noexcept;

}  // namespace farrier::joint_node
