#pragma once

#include <string>
#include <vector>

#include "joint_node/fault_events.hpp"
#include "joint_node/joint_node.hpp"
#include "joint_node/summariser.hpp"
#include "participant/participant.hpp"

namespace farrier::joint_node {

/// A joint this process hosts, with its place in the robot.
struct HostedJoint {
  JointNode node;
  FaultEvents fault_events;
  Summariser summariser;
  std::uint16_t number;
  std::uint16_t leg;
  control::Kind kind;
  std::string name;
};

/// Picks the named joints of the robot, all of them for an empty list. `loop_delay_ticks`: of the clock. Refuses a
/// name the robot does not have.
Result<std::vector<HostedJoint>> host_joints(const robot::Robot& robot, const std::vector<std::string>& names,
                                             int loop_delay_ticks, std::uint64_t session);

/// Says in an event what has changed in a joint's faults, if anything has.
void report_faults(HostedJoint& joint, const signals::JointValveCommand& answered,
                   participant::Participant& participant);

/// The arrows that end or begin at a joint_node.
struct Ports {
  participant::In<signals::JointSensors>* sensors;
  participant::In<signals::JointCommand>* commands;
  participant::In<signals::JointControllerGains>* gains;
  participant::In<signals::GaitPhase>* phases;
  participant::In<signals::SystemMode>* modes;
  participant::Out<signals::JointValveCommand>* valves;
  participant::Out<signals::JointMeasurement>* measurements;
  participant::Out<signals::JointSummary>* summaries;

  static Result<Ports> open(participant::Participant& participant, const std::vector<HostedJoint>& joints,
                            const robot::Robot& robot);

  /// The measurement of a hosted joint, and its summary when one is due; they go with the next flush.
  void tell(HostedJoint& joint, const signals::JointMeasurement& measurement) noexcept;
};

}  // namespace farrier::joint_node
