#include "tools/foxglove/foxglove_display.hpp"

#include "participant/clock.hpp"
#include "recorder/stream.hpp"
#include "urdf/urdf_text.hpp"

namespace farrier::foxglove {

Result<std::unique_ptr<FoxgloveDisplay>> FoxgloveDisplay::create(const display::ListenAddress& address,
                                                                 const robot::Robot& robot) {
  ros_view::RobotMessages::Options options;
  options.ros_namespace = "/" + robot.name;
  if (robot.body) {
    options.description = FARRIER_TRY(urdf::urdf_text(robot));
  }
  ros_view::RobotMessages messages(robot, options);
  auto server = FARRIER_TRY(FoxgloveServer::create(address, "farrier: " + robot.name, messages.topics()));
  if (const std::vector<std::uint8_t> cdr = messages.description_cdr(); !cdr.empty()) {
    server->send(messages.description_topic(), participant::date_now_ns(), cdr);
  }
  return std::unique_ptr<FoxgloveDisplay>(new FoxgloveDisplay(robot, std::move(messages), address, std::move(server)));
}

Result<Done> FoxgloveDisplay::join(bus::Bus& bus) {
  sensors_ = FARRIER_TRY(bus::Subscription<signals::JointSensors>::create(
      bus, recorder::polled_endpoint(robot_, bus::TopicId::kJointSensors)));
  if (robot_.body) {
    imu_ = FARRIER_TRY(recorder::Newest<signals::BodyImu>::create(bus, robot_));
    state_ = FARRIER_TRY(recorder::Newest<signals::BodyState>::create(bus, robot_));
  }
  return Done{};
}

void FoxgloveDisplay::show(const monitor::Frame& frame) {
  for (const monitor::JointFrame& joint : frame.joints) {
    if (joint.newest.tick != kNoTick) {
      messages_.take(joint.newest);
    }
  }
  messages_.take(frame, participant::date_now_ns());
}

void FoxgloveDisplay::step() {
  const recorder::Now now;
  const auto taken = [&now](const auto& sample) { return recorder::publish_time(sample, now.date_ns, now.steady_ns); };
  if (sensors_) {
    sensors_->drain([&](const signals::JointSensors& sample) {
      if (!signals::is_probe(sample)) {
        messages_.take(sample, taken(sample));
      }
    });
  }
  if (imu_ && imu_->drain()) {
    messages_.take(imu_->sample(), taken(imu_->sample()));
  }
  if (state_ && state_->drain()) {
    messages_.take(state_->sample(), taken(state_->sample()));
  }
  messages_.publish(now.date_ns, [this](std::size_t topic, std::uint64_t time_ns, std::span<const std::uint8_t> cdr) {
    server_->send(topic, time_ns, cdr);
  });
}

std::string FoxgloveDisplay::url() const {
  display::ListenAddress address = address_;
  address.port = static_cast<std::uint16_t>(server_->port());
  return "ws://" + address.text();
}

std::string FoxgloveDisplay::summary() const {
  const ServerCounts counts = server_->counts();
  return std::to_string(counts.viewers) + " viewers, " + std::to_string(counts.sent) + " messages sent, " +
         std::to_string(counts.dropped) + " dropped for slow viewers";
}

}  // namespace farrier::foxglove
