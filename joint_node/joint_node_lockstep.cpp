#include "joint_node/joint_node_lockstep.hpp"

#include "joint_node/gains_check.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::joint_node {
namespace {

std::vector<std::uint16_t> numbers_of(const std::vector<HostedJoint>& joints) {
  std::vector<std::uint16_t> numbers;
  for (const HostedJoint& joint : joints) {
    numbers.push_back(joint.number);
  }
  return numbers;
}

class JointNodeLockstep final : public participant::Application {
 public:
  JointNodeLockstep(std::vector<HostedJoint> joints, Ports ports, participant::Participant& participant,
                    std::size_t legs, Tick ticks)
      : joints_(std::move(joints)),
        ports_(ports),
        participant_(participant),
        ticks_(ticks),
        sensors_(numbers_of(joints_)),
        commands_(numbers_of(joints_)),
        announced_phases_(legs, 0) {}

  void poll(SteadyTime now) override;
  bool finished() const override { return ticks_ > 0 && tick_ >= ticks_; }
  int missing() const override;
  std::string waits_for() const override;

 private:
  void drain();
  void offer_gains(const signals::JointControllerGains& signal);
  bool ready() const;
  void step();

  std::vector<HostedJoint> joints_;
  Ports ports_;
  participant::Participant& participant_;
  Tick ticks_;  ///< 0: until told to stop
  Tick tick_ = 0;
  participant::TickInbox<signals::JointSensors> sensors_;
  participant::TickInbox<signals::JointCommand> commands_;
  std::vector<std::uint32_t> announced_phases_;  ///< received so far, by leg
  std::uint32_t mode_epoch_ = 0;
};

void JointNodeLockstep::drain() {
  ports_.sensors->drain([&](const auto& sensors) { sensors_.put(sensors); });
  ports_.commands->drain([&](const auto& command) { commands_.put(command); });
  ports_.gains->drain([&](const auto& gains) { offer_gains(gains); });
  ports_.phases->drain([&](const signals::GaitPhase& phase) {
    if (phase.leg < announced_phases_.size()) {
      announced_phases_[phase.leg] = phase.count;
    }
    for (HostedJoint& joint : joints_) {
      if (joint.leg == phase.leg) {
        joint.node.announce_phase(phase);
      }
    }
  });
  ports_.modes->drain([&](const signals::SystemMode& mode) {
    mode_epoch_ = mode.epoch;
    for (HostedJoint& joint : joints_) {
      joint.node.set_mode(mode);
    }
  });
}

void JointNodeLockstep::offer_gains(const signals::JointControllerGains& signal) {
  for (HostedJoint& joint : joints_) {
    if (joint.number != signal.joint) {
      continue;
    }
    if (const auto checked = check_gains(signal, joint.kind); !checked) {
      joint.node.refuse_gains(signal);
      participant_.event(participant::EventKind::kGainsRefused, tick_, joint.number, checked.error().message);
    } else {
      joint.node.store_gains(signal, wire_gains::unpack_gains(signal));
    }
  }
}

bool JointNodeLockstep::ready() const {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const signals::JointSensors* sensors = sensors_.find(i, tick_);
    const signals::JointCommand* command = commands_.find(i, tick_);
    if (sensors == nullptr || command == nullptr || mode_epoch_ < sensors->required_epoch ||
        joints_[i].node.newest_generation() < sensors->required_generation ||
        announced_phases_[joints_[i].leg] < command->announced_phases) {
      return false;
    }
  }
  return true;
}

void JointNodeLockstep::step() {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    JointNode::Inputs inputs;
    inputs.tick = tick_;
    inputs.sensors = *sensors_.find(i, tick_);
    inputs.command = *commands_.find(i, tick_);
    const JointNode::Outputs outputs = joints_[i].node.step(inputs);
    ports_.valves->publish(outputs.valve);
    ports_.tell(joints_[i], outputs.measurement);
    report_faults(joints_[i], outputs.valve, participant_);
  }
  ports_.valves->flush();
  ports_.measurements->flush();
  ports_.summaries->flush();
  participant_.tick_done(tick_);
  ++tick_;
  if (tick_ == ticks_) {
    participant_.report_health(tick_, true);
  }
}

void JointNodeLockstep::poll(SteadyTime now) {
  drain();
  if (participant_.started(now)) {
    while (!finished() && ready()) {
      step();
    }
  }
}

int JointNodeLockstep::missing() const {
  const int count = sensors_.missing(tick_) + commands_.missing(tick_);
  return count > 0 ? count : 1;
}

std::string JointNodeLockstep::waits_for() const {
  if (const std::string lacking = participant_.greeting_lacks(); !lacking.empty()) {
    return lacking;
  }
  const auto place = [&](const char* what, std::uint16_t number) {
    for (const HostedJoint& joint : joints_) {
      if (joint.number == number) {
        return std::string(what) + " of " + joint.name + " at tick " + std::to_string(tick_);
      }
    }
    return std::string(what);
  };
  if (sensors_.missing(tick_) > 0) {
    return place("joint/sensors", sensors_.first_missing(tick_));
  }
  if (commands_.missing(tick_) > 0) {
    return place("joint/command", commands_.first_missing(tick_));
  }
  return "gains, mode or phase that tick " + std::to_string(tick_) + " asks for";
}

}  // namespace

Result<std::unique_ptr<participant::Application>> create_lockstep(const robot::Robot& robot,
                                                                  const std::vector<std::string>& joints,
                                                                  participant::Participant& participant,
                                                                  Tick ticks) {
  auto hosted = FARRIER_TRY(host_joints(robot, joints, robot.loop_delay_lockstep, participant.identity().session));
  auto ports = FARRIER_TRY(Ports::open(participant, hosted, robot));
  return std::unique_ptr<participant::Application>(std::make_unique<JointNodeLockstep>(
      std::move(hosted), ports, participant, robot.plan.legs.size(), ticks));
}

}  // namespace farrier::joint_node
