#include "tools/ros/joint_command_source.hpp"

#include <cmath>
#include <vector>

#include "core/fault.hpp"
#include "participant/clock.hpp"
#include "robot/keys.hpp"
#include "tools/ros/ros_qos.hpp"

namespace farrier::ros_bridge {
namespace {

constexpr const char* kJointCommands = "joint_commands";
constexpr const char* kImpedanceCommands = "impedance_commands";

class JointCommandSource final : public locomotion::Locomotion {
 public:
  static Result<std::unique_ptr<participant::Application>> create(const robot::Robot& robot,
                                                                  participant::Participant& participant,
                                                                  Nanoseconds timeout, JointCommandReaders& readers,
                                                                  JointCommandState& state) {
    const Ports ports = FARRIER_TRY(Ports::open(participant, robot));
    const std::vector<std::uint16_t> joints = robot::joint_numbers(robot);
    auto* const sensors =
        FARRIER_TRY(participant.subscribe<signals::JointSensors>(joints, robot::legs_of_joints(robot), kPolled));
    auto* const summaries = FARRIER_TRY(participant.subscribe<signals::JointSummary>(joints, {}, kPolled));
    return std::unique_ptr<participant::Application>(
        new JointCommandSource(robot, participant, ports, {sensors, summaries}, timeout, readers, state));
  }

 private:
  static constexpr int kPolled = 1;  // newest samples alone, which wake nobody: clock/tick does

  struct Inputs {
    participant::In<signals::JointSensors>* sensors;
    participant::In<signals::JointSummary>* summaries;
  };

  JointCommandSource(const robot::Robot& robot, participant::Participant& participant, Ports ports, Inputs inputs,
                     Nanoseconds timeout, JointCommandReaders& readers, JointCommandState& state)
      : Locomotion(robot, participant, ports, 0),
        inputs_(inputs),
        timeout_(timeout),
        readers_(readers),
        state_(state),
        references_(robot, timeout),
        joints_(robot.joints.size()) {}

  void prime() override {}
  void drain() override;
  void begin(Tick first, Tick tick) override;
  void take_commands(SteadyTime now);
  void tell_change(bool silent);
  void note(const std::string& refusal) {
    if (!refusal.empty()) {
      state_.notices.put(signals::Severity::kWarning, "refused: " + refusal);
    }
  }

  Inputs inputs_;
  Nanoseconds timeout_;
  JointCommandReaders& readers_;
  JointCommandState& state_;
  JointReferences references_;
  std::vector<JointNow> joints_;
  SteadyTime looked_{};
  int silences_ = 0;
};

void JointCommandSource::drain() {
  if (state_.ends) {
    participant().give_up("leaves the run");
  }
  inputs_.sensors->drain([this](const signals::JointSensors& sensors) {
    const double angle_rad = robot().joints[sensors.joint].linkage.angle(sensors.position_m_or_rad);
    joints_[sensors.joint].angle_rad = std::isfinite(angle_rad) ? std::optional(angle_rad) : std::nullopt;
  });
  inputs_.summaries->drain([this](const signals::JointSummary& summary) {
    const FaultSet faults(summary.faults);
    joints_[summary.joint].follows = !faults.has(Fault::kDisarmed) && !faults.has(Fault::kTripped);
  });
  take_commands(participant::steady_now());
}

void JointCommandSource::take_commands(SteadyTime now) {
  // Messages that waited while this process was not run are older than they look.
  const bool was_not_run = looked_ != SteadyTime{} && now - looked_ > timeout_;
  looked_ = now;
  if (was_not_run) {
    references_.forget();
  }
  const bool counts = !was_not_run && participant().has_started();
  readers_.joints.take([&](const sensor_msgs::JointState& message, std::uint64_t sender) {
    note(counts ? references_.take(kJointCommands, message, sender, now, joints_) : "");
  });
  readers_.impedances.take([&](const control_msgs::DynamicJointState& message, std::uint64_t sender) {
    note(counts ? references_.take(kImpedanceCommands, message, sender, now, joints_) : "");
  });
}

// The number makes each silence a text of its own, which Notices says however soon it follows another.
void JointCommandSource::tell_change(bool silent) {
  if (silent) {
    state_.notices.put(
        signals::Severity::kWarning,
        "joint commands are silent, silence " + std::to_string(++silences_) + " of this run: joints damp, and trip");
  } else {
    state_.notices.put(signals::Severity::kInfo, "joints follow commands of ROS");
  }
}

void JointCommandSource::begin(Tick /*first*/, Tick tick) {
  const auto references = references_.references(participant::steady_now());
  const bool silent = references.empty();
  if (state_.commands.exchange(!silent) == silent) {
    tell_change(silent);
  }
  if (silent) {
    return;
  }
  for (const robot::Joint& joint : robot().joints) {
    const JointReference& reference = references[joint.number];
    signals::JointCommand command = command_for(joint, tick + 1);
    command.position_rad = reference.position_rad;
    command.velocity_rad_s = reference.velocity_rad_s;
    command.torque_ff_Nm = reference.torque_ff_Nm;
    command.stiffness_Nm_rad = reference.stiffness_Nm_rad;
    command.damping_Nms_rad = reference.damping_Nms_rad;
    ports().commands->publish(command);
  }
  ports().commands->flush();
}

}  // namespace

Result<JointCommandReaders> JointCommandReaders::open(bus_ros::RosNode& node) {
  return JointCommandReaders{
      FARRIER_TRY(node.reader<sensor_msgs::JointState>(kJointCommands, kCommandsQos)),
      FARRIER_TRY(node.reader<control_msgs::DynamicJointState>(kImpedanceCommands, kCommandsQos))};
}

Result<std::unique_ptr<participant::Application>> create_joint_command_source(const robot::Robot& robot,
                                                                              participant::Participant& participant,
                                                                              Nanoseconds timeout,
                                                                              JointCommandReaders& readers,
                                                                              JointCommandState& state) {
  return JointCommandSource::create(robot, participant, timeout, readers, state);
}

}  // namespace farrier::ros_bridge
