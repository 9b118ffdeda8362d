#include "joint_node/fault_assessor.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::joint_node {
namespace {

bool finite(const signals::JointCommand& c) noexcept {
  return std::isfinite(c.position_rad) && std::isfinite(c.velocity_rad_s) && std::isfinite(c.torque_ff_Nm) &&
         std::isfinite(c.stiffness_Nm_rad) && std::isfinite(c.damping_Nms_rad) && c.stiffness_Nm_rad >= 0 &&
         c.damping_Nms_rad >= 0;
}

/// A node that has not stepped for `command_trip_s` ignored its commands, even if newer ones have arrived.
bool obeyed(const Situation& s) noexcept {
  return s.command_age_s <= s.limits.command_trip_s && s.since_last_step_s <= s.limits.command_trip_s;
}

/// Flow law and PID have gains of their own.
bool needs_gains(const robot::Joint& joint) noexcept {
  return joint.kind == control::Kind::kLqr || joint.kind == control::Kind::kFlowInversion;
}

struct Condition {
  Fault fault;
  bool (*holds)(const Situation& s) noexcept;  ///< null: the fault is not found here
};

using enum Fault;
// clang-format off
constexpr std::array kConditions{
    Condition{kDisarmed,         [](const Situation& s) noexcept { return !s.armed(); }},
    Condition{kTripped,          [](const Situation& s) noexcept { return s.armed() && s.command.tick != kNoTick && !obeyed(s); }},
    Condition{kSensorsStale,     [](const Situation& s) noexcept { return !s.readings.motion; }},
    Condition{kNoGains,          [](const Situation& s) noexcept { return needs_gains(s.joint) && !s.has_gains; }},
    Condition{kCommandStale,     [](const Situation& s) noexcept { return !finite(s.command) || !(s.command_age_s <= s.limits.command_damping_s); }},
    Condition{kGainsRefused,     [](const Situation& s) noexcept { return s.gains_refused; }},
    Condition{kReferenceClamped, nullptr},  // JointNode::force_reference
    Condition{kValveSaturated,   nullptr},  // valve_current.cpp
    Condition{kActuatorSilent,   nullptr},  // sim_bridge
    Condition{kForceLost,        [](const Situation& s) noexcept { return !s.readings.force; }},
};
// clang-format on

static_assert(std::ranges::equal(kConditions, kFaults, {}, &Condition::fault, &FaultInfo::fault),
              "every row of the safety table has its condition, in the order of kFaults");

}  // namespace

bool Situation::armed() const noexcept { return mode.epoch != 0 && mode.mode == signals::Mode::kArmed; }

void FaultAssessor::assess(const Situation& now, FaultSet& faults) noexcept {
  for (std::size_t row = 0; row < kFaults.size(); ++row) {
    if (kConditions[row].holds == nullptr) {
      continue;
    }
    const Fault fault = kFaults[row].fault;
    const bool holds = kConditions[row].holds(now);
    switch (kFaults[row].clears) {
      case Clears::kWithCondition:
        faults.set(fault, holds);
        break;
      case Clears::kAfterGoodSamples: {
        const int enough = now.limits.recovery_samples;
        good_samples_[row] = holds ? 0 : std::min(good_samples_[row] + now.readings.new_samples, enough);
        faults.set(fault, good_samples_[row] < enough);
        break;
      }
      case Clears::kByArming:
        if (faults.has(fault) && now.armed() && now.mode.epoch > latched_epoch_[row]) {
          faults.set(fault, false);
        }
        if (holds && !faults.has(fault)) {
          faults.set(fault);
          latched_epoch_[row] = now.mode.epoch;
        }
        break;
    }
  }
}

signals::JointState state_of(SafeOutput output) noexcept {
  switch (output) {
    case SafeOutput::kTracking:
      return signals::JointState::kTracking;
    case SafeOutput::kDamping:
    case SafeOutput::kPositionDamping:
      return signals::JointState::kDamping;
    case SafeOutput::kNull:
      return signals::JointState::kNull;
  }
  return signals::JointState::kNull;
}

}  // namespace farrier::joint_node
