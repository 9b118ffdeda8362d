#include "tools/ros/status_topics.hpp"

#include "ros_view/topics.hpp"
#include "tools/ros/ros_qos.hpp"

namespace farrier::ros_bridge {

Result<StatusTopics> StatusTopics::create(bus::Bus& bus, const robot::Robot& robot, bus_ros::RosNode& node) {
  using enum bus::TopicId;
  auto slow_topics = FARRIER_TRY(
      recorder::Recorder::create(bus, robot, {kJointSummary, kSystemMode, kSystemHello, kSystemHealth, kSystemEvent}));
  return StatusTopics(robot, std::move(slow_topics),
                      FARRIER_TRY(node.writer<diagnostic_msgs::DiagnosticArray>(ros_view::kDiagnostics, kStreamQos)));
}

void StatusTopics::look(SteadyTime now) {
  const auto now_ns = static_cast<std::uint64_t>(now.time_since_epoch().count());
  slow_topics_.drain([&](recording::Sample sample) {
    sample.log_time_ns = now_ns;
    view_.take(sample);
  });
  frame_ = view_.frame(now_ns);
  for (const monitor::ParticipantFrame& process : frame_.participants) {
    session_ = process.hello.session != 0 ? process.hello.session : session_;
  }
}

}  // namespace farrier::ros_bridge
