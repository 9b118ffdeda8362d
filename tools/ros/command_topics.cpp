#include "tools/ros/command_topics.hpp"

namespace farrier::ros_bridge {

Result<CommandTopics> CommandTopics::create(bus::Bus& bus, const robot::Robot& robot, bus_ros::RosNode& node,
                                            const CommandOptions& options) {
  auto operators = FARRIER_TRY(OperatorTopics::create(bus, robot, node, options.arm));
  CommandTopics topics(std::move(operators), options.joints ? options.joints->participants : 0);
  if (options.joints) {
    auto readers = FARRIER_TRY(JointCommandReaders::open(node));
    topics.joints_ = std::make_unique<JointCommandRun>(*options.joints, std::move(readers), options.timeout);
  } else {
    topics.velocities_ = FARRIER_TRY(VelocityTopics::create(bus, robot, node, options.timeout));
  }
  return topics;
}

std::string CommandTopics::cannot_arm() const {
  return joints_ != nullptr && !joints_->commands()
             ? "joints that get no commands trip: send joint_commands or impedance_commands first"
             : "";
}

void CommandTopics::take(const Run& run, MotionMode motion, SteadyTime now, const Tell& tell) {
  operators_.take(run, cannot_arm(), now, tell);
  if (velocities_) {
    velocities_->take(run, motion, now,
                      [&](const std::string& refusal) { tell(signals::Severity::kWarning, "refused: " + refusal); });
  }
  if (joints_ != nullptr) {
    for (const NoticeQueue::Notice& notice : joints_->notices().take()) {
      tell(notice.severity, notice.text);
    }
  }
}

void CommandTopics::look(const monitor::Frame& frame, const Tell& tell) {
  if (joints_ != nullptr) {
    tell(signals::Severity::kError, joints_->look(frame, participants_));
  }
}

}  // namespace farrier::ros_bridge
