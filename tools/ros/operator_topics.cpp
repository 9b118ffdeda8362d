#include "tools/ros/operator_topics.hpp"

#include <algorithm>

#include "tools/ros/ros_qos.hpp"

namespace farrier::ros_bridge {
namespace {

// For the request's way and the supervisor's answer.
constexpr Nanoseconds kPatience = std::chrono::seconds(5);
// A sender that repeats its stop asks for a robot that is stopped at most so often.
constexpr Nanoseconds kStopAgain = std::chrono::milliseconds(100);

}  // namespace

Result<OperatorTopics> OperatorTopics::create(bus::Bus& bus, const robot::Robot& robot, bus_ros::RosNode& node,
                                              bool arm) {
  auto stop = FARRIER_TRY(node.reader<Bool>("stop", kCommandsQos));
  auto repeated_stop = FARRIER_TRY(node.reader<Bool>("stop", kRepeatedCommandsQos));
  std::optional<bus_ros::RosReader<Bool>> armed;
  if (arm) {
    armed = FARRIER_TRY(node.reader<Bool>("arm", kRepeatedCommandsQos));
  }
  auto requests = FARRIER_TRY(bus::Publisher<signals::SystemRequest>::create(
      bus, participant::endpoint_of(participant::operator_of(robot.name), bus::TopicId::kSystemRequest)));
  auto modes = FARRIER_TRY(Newest<signals::SystemMode>::create(bus, robot));
  return OperatorTopics(std::move(stop), std::move(repeated_stop), std::move(armed), std::move(requests),
                        std::move(modes));
}

void OperatorTopics::ask(signals::Request what, const Run& run, SteadyTime now, const Tell& tell) {
  const bool stops = what == signals::Request::kStop;
  const std::string asked = stops ? "a node of ROS stops the robot" : "a node of ROS arms the robot";
  if (run.session == 0) {
    tell(signals::Severity::kWarning, asked + ", but no robot is heard");
    return;
  }
  tell(stops ? signals::Severity::kWarning : signals::Severity::kInfo, asked);
  pending_stop_ = stops;
  pending_.emplace(run.session, what, std::max<Tick>(run.tick, 0));
  pending_->take(modes_.sample());
  asked_ = now;
}

bool OperatorTopics::stop_is_due(const Run& run, SteadyTime now) const noexcept {
  const signals::SystemMode& mode = modes_.sample();
  const bool stopped = mode.session == run.session && mode.epoch != 0 && mode.mode == signals::Mode::kStopped;
  return !((stopped || pending_stop_) && asked_ != SteadyTime{} && now - asked_ < kStopAgain);
}

void OperatorTopics::follow(SteadyTime now, const Tell& tell) {
  if (!pending_) {
    return;
  }
  if (const auto due = pending_->due(now, requests_.matched_readers() > 0)) {
    requests_.publish(*due);
  }
  if (const auto& answer = pending_->answer()) {
    tell(signals::Severity::kInfo, std::string("the robot is ") + signals::to_string(answer->mode));
    forget();
  } else if (now - asked_ > kPatience) {
    tell(signals::Severity::kError, "no supervisor answers a request of ROS");
    forget();
  }
}

void OperatorTopics::take(const Run& run, const std::string& cannot_arm, SteadyTime now, const Tell& tell) {
  if (modes_.drain() && pending_) {
    pending_->take(modes_.sample());
  }
  bool stops = false, arms = false;
  const auto take_stop = [&](const Bool& message, std::uint64_t) { stops = pulses_.stop(message.data, now) || stops; };
  stop_.take(take_stop);
  repeated_stop_.take(take_stop);
  if (arm_) {
    arm_->take([&](const Bool& message, std::uint64_t) { arms = pulses_.arm(message.data, now) || arms; });
  }
  if (stops && stop_is_due(run, now)) {
    ask(signals::Request::kStop, run, now, tell);
  } else if (arms && !stops && !cannot_arm.empty()) {
    tell(signals::Severity::kWarning, "refused: arm: " + cannot_arm);
  } else if (arms && !stops) {
    ask(signals::Request::kArm, run, now, tell);
  }
  follow(now, tell);
}

}  // namespace farrier::ros_bridge
