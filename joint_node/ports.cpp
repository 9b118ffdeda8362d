#include "joint_node/ports.hpp"

#include "robot/keys.hpp"

namespace farrier::joint_node {

Result<std::vector<HostedJoint>> host_joints(const robot::Robot& robot, const std::vector<std::string>& names,
                                             int loop_delay_ticks, std::uint64_t session) {
  std::vector<HostedJoint> hosted;
  const auto host = [&](const robot::Joint& joint) {
    hosted.push_back({JointNode(joint, robot.safety, robot.period_s, loop_delay_ticks, session),
                      {},
                      Summariser(robot.period_s, static_cast<Tick>(joint.leg)),
                      joint.number,
                      static_cast<std::uint16_t>(joint.leg),
                      joint.kind,
                      joint.name});
  };
  for (const std::string& name : names) {
    const robot::Joint* joint = robot.find(name);
    if (joint == nullptr) {
      return Error{"--joints: " + robot.name + " has no joint '" + name + "'"};
    }
    host(*joint);
  }
  if (names.empty()) {
    for (const robot::Joint& joint : robot.joints) {
      host(joint);
    }
  }
  return hosted;
}

void report_faults(HostedJoint& joint, const signals::JointValveCommand& answered,
                   participant::Participant& participant) {
  const FaultSet faults(answered.faults);
  if (const auto change = joint.fault_events.update(answered.tick, faults)) {
    // A joint that is not armed is at null because nobody has asked it for more.
    const bool nulled = answered.state == signals::JointState::kNull && !faults.has(Fault::kDisarmed);
    participant.event(nulled ? participant::EventKind::kJointNulled : participant::EventKind::kJointFaults,
                      answered.tick, joint.number, *change);
  }
}

Result<Ports> Ports::open(participant::Participant& participant, const std::vector<HostedJoint>& joints,
                          const robot::Robot& robot) {
  std::vector<std::uint16_t> numbers;
  std::vector<std::string> legs;
  for (const HostedJoint& joint : joints) {
    numbers.push_back(joint.number);
    legs.push_back(robot.plan.legs[joint.leg].name);
  }
  const auto sensors = participant.subscribe<signals::JointSensors>(numbers, legs);
  const auto commands = participant.subscribe<signals::JointCommand>(numbers, legs);
  const auto gains = participant.subscribe<signals::JointControllerGains>(numbers, legs);
  const auto phases = participant.subscribe<signals::GaitPhase>(robot::leg_numbers(robot));
  const auto modes = participant.subscribe<signals::SystemMode>({0});
  const auto valves = participant.publish<signals::JointValveCommand>(numbers);
  const auto measurements = participant.publish<signals::JointMeasurement>(numbers);
  const auto summaries = participant.publish<signals::JointSummary>(numbers);
  for (const auto* refused :
       {sensors ? nullptr : &sensors.error(), commands ? nullptr : &commands.error(), gains ? nullptr : &gains.error(),
        phases ? nullptr : &phases.error(), modes ? nullptr : &modes.error(), valves ? nullptr : &valves.error(),
        measurements ? nullptr : &measurements.error(), summaries ? nullptr : &summaries.error()}) {
    if (refused != nullptr) {
      return *refused;
    }
  }
  return Ports{sensors.value(), commands.value(), gains.value(),        phases.value(),
               modes.value(),   valves.value(),   measurements.value(), summaries.value()};
}

void Ports::tell(HostedJoint& joint, const signals::JointMeasurement& measurement) noexcept {
  measurements->publish(measurement);
  if (const auto summary = joint.summariser.take(measurement)) {
    summaries->publish(*summary);
  }
}

}  // namespace farrier::joint_node
