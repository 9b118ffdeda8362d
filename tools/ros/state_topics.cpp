#include "tools/ros/state_topics.hpp"

#include "ros_view/topics.hpp"
#include "tools/ros/ros_qos.hpp"

namespace farrier::ros_bridge {
namespace {

constexpr Nanoseconds kSlow = std::chrono::milliseconds(20);  // dynamic_joint_states and /tf

}  // namespace

StateTopics::StateTopics(const robot::Robot& robot, const SampleStamps& stamps,
                         Writer<sensor_msgs::JointState> joint_states,
                         Writer<control_msgs::DynamicJointState> dynamic_joint_states,
                         bus::Subscription<signals::JointMeasurement> measurements)
    : robot_(robot),
      stamps_(stamps),
      joint_states_(std::move(joint_states)),
      dynamic_joint_states_(std::move(dynamic_joint_states)),
      measurements_(std::move(measurements)),
      joints_(robot.joints.size()),
      due_dynamic_(kSlow),
      due_transforms_(kSlow) {}

Result<StateTopics> StateTopics::create(bus::Bus& bus, const robot::Robot& robot, bus_ros::RosNode& node,
                                        const SampleStamps& stamps, const Options& options) {
  StateTopics topics(
      robot, stamps, FARRIER_TRY(node.writer<sensor_msgs::JointState>(ros_view::kJointStates, kStreamQos)),
      FARRIER_TRY(node.writer<control_msgs::DynamicJointState>(ros_view::kDynamicJointStates, kStreamQos)),
      FARRIER_TRY(bus::Subscription<signals::JointMeasurement>::create(
          bus, polled_endpoint(robot, bus::TopicId::kJointMeasurement))));
  if (robot.body) {
    topics.imu_out_ = FARRIER_TRY(node.writer<sensor_msgs::Imu>(ros_view::kImu, kStreamQos));
    topics.odometry_ = FARRIER_TRY(node.writer<nav_msgs::Odometry>(ros_view::kOdometry, kStreamQos));
    for (const body::LegModel& leg : robot.body->legs) {
      topics.wrenches_.push_back(
          FARRIER_TRY(node.writer<geometry_msgs::WrenchStamped>(ros_view::foot_wrench_topic(leg.name), kStreamQos)));
    }
    topics.imu_ = FARRIER_TRY(Newest<signals::BodyImu>::create(bus, robot));
    topics.state_ = FARRIER_TRY(Newest<signals::BodyState>::create(bus, robot));
  }
  if (options.transforms) {
    topics.transforms_ = FARRIER_TRY(node.writer<tf2_msgs::TFMessage>(ros_view::kTransforms, kTransformsQos));
  }
  if (options.clock) {
    topics.clock_ = FARRIER_TRY(node.writer<rosgraph_msgs::Clock>("/clock", kClockQos));
  }
  return topics;
}

void StateTopics::hear_joints() {
  measurements_.drain([this](const signals::JointMeasurement& sample) {
    if (signals::is_probe(sample) || sample.joint >= joints_.size()) {
      return;
    }
    signals::JointSensors& sensors = joints_[sample.joint].sensors;
    sensors.joint = sample.joint;
    sensors.tick = sample.tick;
    sensors.sample_time_ns = sample.sample_time_ns;
    sensors.position_m_or_rad = sample.position_m_or_rad;
    sensors.velocity_m_s_or_rad_s = sample.velocity_m_s_or_rad_s;
    sensors.force_N_or_Nm = sample.force_N_or_Nm;
    if (sample.tick >= tick_) {
      tick_ = sample.tick;
      sample_time_ns_ = sample.sample_time_ns;
    }
  });
}

void StateTopics::publish_joints(SteadyTime now) {
  const Tick before = tick_;
  hear_joints();
  if (tick_ == before) {
    return;
  }
  const Time stamp = stamps_.of(tick_, sample_time_ns_);
  if (clock_) {
    clock_->write({.clock = stamp});
  }
  if (joint_states_.has_readers()) {
    sent_ += joint_states_.write(ros_view::joint_state(robot_, joints_, stamp)) ? 1 : 0;
  }
  if (due_dynamic_.now(now) && dynamic_joint_states_.has_readers()) {
    dynamic_joint_states_.write(ros_view::dynamic_joint_state(robot_, joints_, stamp));
  }
}

void StateTopics::publish_body(SteadyTime now) {
  if (imu_ && imu_->drain() && imu_out_->has_readers()) {
    const signals::BodyImu& sample = imu_->sample();
    if (const auto message = ros_view::imu(sample, stamps_.of(sample.tick, sample.sample_time_ns))) {
      imu_out_->write(*message);
    }
  }
  if (state_ && state_->drain()) {
    const signals::BodyState& sample = state_->sample();
    // A state is estimated from the sensors of its tick.
    const Time stamp = stamps_.of(sample.tick, sample.tick == tick_ ? sample_time_ns_ : 0);
    for (std::size_t leg = 0; leg < wrenches_.size(); ++leg) {
      if (!wrenches_[leg].has_readers()) {
        continue;
      }
      if (const auto message = ros_view::foot_wrench(robot_, leg, sample, joints_, stamp)) {
        wrenches_[leg].write(*message);
      }
    }
    if (const auto message = ros_view::odometry(sample, stamp)) {
      odometry_->write(*message);
      if (transforms_ && due_transforms_.now(now)) {
        transforms_->write(ros_view::transform(*message));
      }
    }
  }
}

void StateTopics::publish(SteadyTime now) {
  publish_joints(now);
  publish_body(now);
}

}  // namespace farrier::ros_bridge
