#include "tools/ros/velocity_topics.hpp"

#include <algorithm>

#include "participant/operator.hpp"
#include "tools/ros/ros_qos.hpp"

namespace farrier::ros_bridge {
namespace {

// Locomotion takes half a second of silence for a lost operator.
constexpr Nanoseconds kRepeat = std::chrono::milliseconds(50);

}  // namespace

VelocityTopics::VelocityTopics(bus_ros::RosReader<Twist> velocity, bus_ros::RosReader<TwistStamped> stamped_velocity,
                               bus::Publisher<signals::BodyCommand> commands, Nanoseconds timeout)
    : velocity_(std::move(velocity)),
      stamped_velocity_(std::move(stamped_velocity)),
      commands_(std::move(commands)),
      velocities_(timeout),
      due_(kRepeat) {}

Result<VelocityTopics> VelocityTopics::create(bus::Bus& bus, const robot::Robot& robot, bus_ros::RosNode& node,
                                              Nanoseconds timeout) {
  auto velocity = FARRIER_TRY(node.reader<Twist>("cmd_vel", kCommandsQos));
  auto stamped = FARRIER_TRY(node.reader<TwistStamped>("cmd_vel_stamped", kCommandsQos));
  auto commands = FARRIER_TRY(bus::Publisher<signals::BodyCommand>::create(
      bus, participant::endpoint_of(participant::operator_of(robot.name), bus::TopicId::kBodyCommand)));
  return VelocityTopics(std::move(velocity), std::move(stamped), std::move(commands), timeout);
}

void VelocityTopics::take(const Run& run, MotionMode motion, SteadyTime now,
                          const std::function<void(const std::string&)>& refused) {
  bool came = false;
  const auto take = [&](const Twist& twist, std::uint64_t sender) {
    const std::string refusal = velocities_.take(twist, sender, now);
    came = came || refusal.empty();
    if (!refusal.empty()) {
      refused(refusal);
    }
  };
  velocity_.take(take);
  stamped_velocity_.take([&](const TwistStamped& stamped, std::uint64_t sender) { take(stamped.twist, sender); });
  if (!came && !due_.now(now)) {
    return;
  }
  if (auto command = velocities_.command(now, motion); command && run.session != 0) {
    command->session = run.session;
    command->tick = std::max<Tick>(run.tick, 0);
    command->count = ++count_;
    commands_.publish(*command);
  }
}

}  // namespace farrier::ros_bridge
