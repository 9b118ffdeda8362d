#pragma once

// The whole robot on a ground:
//
//   torques, ideal or of drives ──▶ body::Engine ◀── pushes, payloads of the scene
//                   │ truth
//                   ▼
//   readings ◀── noise, seeded by name and addressed by tick.

#include <array>
#include <cstdint>
#include <vector>

#include "body/dynamics/rigid_body.hpp"
#include "body/engine/engine.hpp"
#include "body/scene/scene.hpp"
#include "core/noise.hpp"
#include "robot/robot.hpp"
#include "world/joint_drives.hpp"
#include "world/world.hpp"

namespace farrier::world {

/// Standard deviations of the sensors, each >= 0, and the delay of the IMU.
struct BodyNoise {
  double angle_rad = 0.0;
  double velocity_rad_s = 0.0;
  double torque_Nm = 0.0;
  double attitude_rad = 0.0;  ///< about each axis of the trunk
  double rate_rad_s = 0.0;
  double specific_force_m_s2 = 0.0;
  double rate_bias_rad_s = 0.0;  ///< of biases at the start, drawn per axis from the seed
  double specific_force_bias_m_s2 = 0.0;
  double rate_walk_rad_s15 = 0.0;  ///< of the biases' random walk: rad/s per sqrt(s), m/s^2 per sqrt(s)
  double specific_force_walk_m_s25 = 0.0;
  int imu_delay_ticks = 0;  ///< the IMU tells the state of so many ticks ago, 0..kMostImuDelay
};
inline constexpr int kMostImuDelay = 16;

/// The IMU of a walking robot: noise of the Xsens MTi-1 (doi:10.2478/tar-2023-0022), whose densities of 0.007
/// deg/s/sqrt(Hz) and 120 ug/sqrt(Hz) pass first-order bandwidths of 255 and 324 Hz. Its biases walk to their
/// instabilities of 10 deg/h and 0.03 mg in 100 s. Biases at the start and the delay are assumed; it tells every tick.
inline constexpr BodyNoise kImuNoise{.rate_rad_s = 0.00245,
                                     .specific_force_m_s2 = 0.0266,
                                     .rate_bias_rad_s = 0.0035,
                                     .specific_force_bias_m_s2 = 0.02,
                                     .rate_walk_rad_s15 = 4.8e-6,
                                     .specific_force_walk_m_s25 = 2.9e-5,
                                     .imu_delay_ticks = 2};

/// The same robot, scene, noise, seed and torques give the same numbers bit for bit.
class BodyWorld final : public World {
 public:
  /// The robot stands at rest in its home pose, upright on the ground's plane, its origin above the world's. Its joints
  /// are ideal sources of torque between stops at the limits of the file. Refuses a robot that its file does not
  /// describe as rigid bodies, and a start with a foot in a box. `finer` >= 1 divides the steps in a tick.
  static Result<BodyWorld> create(const robot::Robot& robot, const body::Scene& scene, std::uint64_t seed,
                                  const BodyNoise& noise = {}, int finer = 1);

  Tick tick() const noexcept override { return tick_; }
  std::size_t joints() const noexcept override { return static_cast<std::size_t>(body_.joints()); }
  /// Angle, velocity and torque of the hinge. The torque is that of the last tick.
  JointReading reading(std::size_t joint) const noexcept override;
  std::optional<ImuReading> imu() const noexcept override;
  bool advance(std::span<const double> torques_Nm) noexcept override;
  /// The same with torques that change from step to step.
  bool advance(JointDrives& drives) noexcept;
  std::optional<std::string> failure() const override;

  /// The true state. Only reports and tests read it.
  const body::BodyState& state() const noexcept { return state_; }
  /// The true kinematics and dynamics at that state, without payloads.
  const body::RigidBody& body() const noexcept { return body_; }
  /// The model that the engine simulates, and its steps in a tick.
  const body::BodyModel& model() const noexcept { return model_; }
  int steps_per_tick() const noexcept { return steps_per_tick_; }
  /// Normal of the ground's plane, in the world.
  Eigen::Vector3d ground_normal() const noexcept { return scene_.ground * Eigen::Vector3d::UnitZ(); }
  /// Push of the scene on the trunk over the coming tick, world's axes.
  Eigen::Vector3d push_N() const noexcept { return body::push_force_N(scene_, time_s(tick_), time_s(tick_ + 1)); }
  /// Force of the ground on a foot, the mean of the last tick, world's axes.
  const Eigen::Vector3d& foot_force_N(int leg) const noexcept { return foot_forces_N_[leg]; }

 private:
  struct JointNoise {
    NoiseStream angle, velocity, torque;
  };
  struct AxisNoise {
    NoiseStream attitude, rate, specific_force, rate_walk, specific_force_walk;
    double rate_bias_rad_s, specific_force_bias_m_s2;
  };

  BodyWorld(const robot::Robot& robot, const body::Scene& scene, std::uint64_t seed, const BodyNoise& noise,
            body::RigidBody body, body::Engine engine, int steps_per_tick);
  void stand(const robot::Robot& robot) noexcept;
  void put_payloads() noexcept;
  void note_imu() noexcept;
  void walk_biases() noexcept;
  double time_s(Tick tick) const noexcept { return static_cast<double>(tick) * period_s_; }

  body::BodyModel model_;
  body::Scene scene_;
  BodyNoise noise_;
  double period_s_;
  int steps_per_tick_;
  body::RigidBody body_;
  body::Engine engine_;
  body::BodyState state_;
  body::JointVector torques_Nm_;
  Eigen::Vector3d specific_force_m_s2_;
  std::array<ImuReading, kMostImuDelay + 1> imu_truths_{};  // of the last ticks, by tick modulo their number
  std::array<Eigen::Vector3d, body::kMaxLegs> foot_forces_N_{};
  std::vector<JointNoise> joint_noise_;
  std::vector<AxisNoise> axis_noise_;
  Tick tick_ = 0;
};

}  // namespace farrier::world
