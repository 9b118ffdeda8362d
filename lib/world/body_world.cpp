#include "world/body_world.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::world {
namespace {

constexpr double kLongestStep_s = 0.00025;
constexpr double kRounding = 1e-9;

int steps_of(double period_s) noexcept { return static_cast<int>(std::ceil(period_s / kLongestStep_s - kRounding)); }

bool is_possible(const BodyNoise& noise) noexcept {
  for (const double deviation :
       {noise.angle_rad, noise.velocity_rad_s, noise.torque_Nm, noise.attitude_rad, noise.rate_rad_s,
        noise.specific_force_m_s2, noise.rate_bias_rad_s, noise.specific_force_bias_m_s2, noise.rate_walk_rad_s15,
        noise.specific_force_walk_m_s25}) {
    if (!(deviation >= 0.0) || !std::isfinite(deviation)) {
      return false;
    }
  }
  return noise.imu_delay_ticks >= 0 && noise.imu_delay_ticks <= kMostImuDelay;
}

double draw(const NoiseStream& stream, double deviation, Tick tick) noexcept {
  return deviation > 0.0 ? deviation * stream.normal(tick) : 0.0;
}

/// Ideal sources of torque.
class HeldTorques final : public JointDrives {
 public:
  explicit HeldTorques(const body::JointVector& torques_Nm) noexcept : torques_Nm_(torques_Nm) {}
  const body::JointVector& torques_Nm() const noexcept override { return torques_Nm_; }
  void follow(const body::BodyState&, double) noexcept override {}

 private:
  body::JointVector torques_Nm_;
};

body::BodyModel with_stops(const robot::Robot& robot) {
  body::BodyModel model = *robot.body;
  for (const robot::Joint& joint : robot.joints) {
    model.legs[joint.leg].links[joint.index_in_leg].stops = {joint.angle_min_rad, joint.angle_max_rad};
  }
  return model;
}

}  // namespace

BodyWorld::BodyWorld(const robot::Robot& robot, const body::Scene& scene, std::uint64_t seed, const BodyNoise& noise,
                     body::RigidBody body, body::Engine engine, int steps_per_tick)
    : model_(with_stops(robot)),
      scene_(scene),
      noise_(noise),
      period_s_(robot.period_s),
      steps_per_tick_(steps_per_tick),
      body_(std::move(body)),
      engine_(std::move(engine)),
      state_(body::BodyState::zero(body_.joints())),
      torques_Nm_(body::JointVector::Zero(body_.joints())) {
  for (const robot::Joint& joint : robot.joints) {
    joint_noise_.push_back({NoiseStream(seed, joint.name, "angle"), NoiseStream(seed, joint.name, "velocity"),
                            NoiseStream(seed, joint.name, "torque")});
  }
  for (const char* axis : {"imu_x", "imu_y", "imu_z"}) {
    axis_noise_.push_back({NoiseStream(seed, axis, "attitude"), NoiseStream(seed, axis, "rate"),
                           NoiseStream(seed, axis, "specific_force"), NoiseStream(seed, axis, "rate_walk"),
                           NoiseStream(seed, axis, "specific_force_walk"),
                           draw(NoiseStream(seed, axis, "rate_bias"), noise.rate_bias_rad_s, 0),
                           draw(NoiseStream(seed, axis, "specific_force_bias"), noise.specific_force_bias_m_s2, 0)});
  }
  stand(robot);
  note_imu();
  put_payloads();
  engine_.set_state(state_);
}

Result<BodyWorld> BodyWorld::create(const robot::Robot& robot, const body::Scene& scene, std::uint64_t seed,
                                    const BodyNoise& noise, int finer) {
  if (!robot.body) {
    return Error{robot.name +
                 " is not described as rigid bodies: give body.trunk, body.foot_radius_m and the "
                 "hip_position_m of each leg in its file"};
  }
  if (!is_possible(noise)) {
    return Error{
        "a standard deviation of the sensors is negative or not finite, or the delay of the IMU beyond 16 ticks: give "
        "zero for none"};
  }
  body::RigidBody body = FARRIER_TRY(body::RigidBody::create(*robot.body));
  const int steps = finer * steps_of(robot.period_s);
  body::Engine engine = FARRIER_TRY(body::Engine::create(with_stops(robot), scene, {.step_s = robot.period_s / steps}));
  BodyWorld world(robot, scene, seed, noise, std::move(body), std::move(engine), steps);
  FARRIER_TRY(body::check_start(scene, *robot.body, world.body_));
  return world;
}

// The lowest foot touches the plane, to which the trunk is parallel.
void BodyWorld::stand(const robot::Robot& robot) noexcept {
  for (const robot::Joint& joint : robot.joints) {
    state_.angles_rad[joint.number] = joint.home_angle_rad;
  }
  body_.set_state(state_);
  double height_m = -1e9;
  for (int leg = 0; leg < body_.legs(); ++leg) {
    height_m =
        std::max(height_m, model_.legs[static_cast<std::size_t>(leg)].foot_radius_m - body_.foot_position_m(leg).z());
  }
  state_.attitude = scene_.ground;
  state_.position_m = scene_.ground * Eigen::Vector3d(0.0, 0.0, height_m);
  body_.set_state(state_);
  specific_force_m_s2_ = state_.attitude.conjugate() * Eigen::Vector3d(0.0, 0.0, model_.gravity_m_s2);
}

JointReading BodyWorld::reading(std::size_t joint) const noexcept {
  const auto index = static_cast<Eigen::Index>(joint);
  const JointNoise& noise = joint_noise_[joint];
  return {state_.angles_rad[index] + draw(noise.angle, noise_.angle_rad, tick_),
          state_.velocities_rad_s[index] + draw(noise.velocity, noise_.velocity_rad_s, tick_),
          torques_Nm_[index] + draw(noise.torque, noise_.torque_Nm, tick_)};
}

std::optional<ImuReading> BodyWorld::imu() const noexcept {
  Eigen::Vector3d half_turn_rad;
  const Tick then = std::max<Tick>(0, tick_ - noise_.imu_delay_ticks);
  ImuReading imu = imu_truths_[static_cast<std::size_t>(then) % imu_truths_.size()];
  for (int axis = 0; axis < 3; ++axis) {
    const AxisNoise& noise = axis_noise_[static_cast<std::size_t>(axis)];
    half_turn_rad[axis] = 0.5 * draw(noise.attitude, noise_.attitude_rad, tick_);
    imu.rate_rad_s[axis] += noise.rate_bias_rad_s + draw(noise.rate, noise_.rate_rad_s, tick_);
    imu.specific_force_m_s2[axis] +=
        noise.specific_force_bias_m_s2 + draw(noise.specific_force, noise_.specific_force_m_s2, tick_);
  }
  // A small rotation: its quaternion is (1, half the vector of rotation) to second order.
  const Eigen::Quaterniond turn(1.0, half_turn_rad.x(), half_turn_rad.y(), half_turn_rad.z());
  imu.attitude = (imu.attitude * turn).normalized();
  return imu;
}

void BodyWorld::note_imu() noexcept {
  imu_truths_[static_cast<std::size_t>(tick_) % imu_truths_.size()] = {state_.attitude, state_.angular_velocity_rad_s,
                                                                       specific_force_m_s2_};
}

void BodyWorld::walk_biases() noexcept {
  const double root_s = std::sqrt(period_s_);
  for (AxisNoise& axis : axis_noise_) {
    axis.rate_bias_rad_s += draw(axis.rate_walk, noise_.rate_walk_rad_s15 * root_s, tick_);
    axis.specific_force_bias_m_s2 += draw(axis.specific_force_walk, noise_.specific_force_walk_m_s25 * root_s, tick_);
  }
}

// A payload is there from the first tick that begins at or after its time.
void BodyWorld::put_payloads() noexcept {
  const double now_s = time_s(tick_);
  const double before_s = time_s(tick_ - 1);
  const bool changes = std::ranges::any_of(scene_.payloads, [now_s, before_s](const body::Payload& payload) {
    return payload.start_s <= now_s && payload.start_s > before_s;
  });
  if (changes) {
    engine_.set_trunk(body::loaded_trunk(model_.trunk, scene_, now_s));
  }
}

bool BodyWorld::advance(std::span<const double> torques_Nm) noexcept {
  HeldTorques held(Eigen::Map<const Eigen::VectorXd>(torques_Nm.data(), body_.joints()));
  return advance(held);
}

bool BodyWorld::advance(JointDrives& drives) noexcept {
  if (engine_.failure()) {
    return false;
  }
  const body::TrunkWrench wrench{push_N(), Eigen::Vector3d::Zero()};
  foot_forces_N_.fill(Eigen::Vector3d::Zero());
  for (int step = 0; step < steps_per_tick_; ++step) {
    torques_Nm_ = drives.torques_Nm();
    engine_.step(torques_Nm_, wrench);
    if (!engine_.failure()) {
      drives.follow(engine_.state(), period_s_ / steps_per_tick_);
    }
    for (int leg = 0; leg < body_.legs(); ++leg) {
      foot_forces_N_[leg] += engine_.contact_force_N(leg) / steps_per_tick_;
    }
  }
  if (engine_.failure()) {
    return false;
  }
  const Eigen::Vector3d velocity_before_m_s = state_.linear_velocity_m_s;
  state_ = engine_.state();
  body_.set_state(state_);
  const Eigen::Vector3d gravity_m_s2(0.0, 0.0, -model_.gravity_m_s2);
  specific_force_m_s2_ =
      state_.attitude.conjugate() * ((state_.linear_velocity_m_s - velocity_before_m_s) / period_s_ - gravity_m_s2);
  ++tick_;
  note_imu();
  walk_biases();
  put_payloads();
  return true;
}

std::optional<std::string> BodyWorld::failure() const {
  if (!engine_.failure()) {
    return std::nullopt;
  }
  return "the body cannot be simulated beyond tick " + std::to_string(tick_) + ": " +
         body::to_string(engine_.failure()->fault);
}

}  // namespace farrier::world
