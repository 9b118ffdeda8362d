#pragma once

// The robot and its surroundings, as the processes see them:
//
//   readings of tick k ──▶ controllers ──▶ commands ──▶ advance() ──▶ readings of tick k + 1
//
// A world has no clock and no bus. Two exist: the bench (sim_bridge/sim_world.hpp) simulates each joint by itself, a body
// (body_world.hpp) the whole robot on a ground.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "core/time.hpp"

namespace farrier::world {

/// Readings of one joint's sensors, in the coordinates of its actuator: m, m/s and N of a cylinder, rad, rad/s and Nm of
/// everything else.
struct JointReading {
  double position = 0.0;
  double velocity = 0.0;
  double force = 0.0;
};

/// Readings of the trunk's inertial measurement unit, which sits in the trunk's origin.
struct ImuReading {
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  ///< from the trunk's axes to the world's; unit
  Eigen::Vector3d rate_rad_s = Eigen::Vector3d::Zero();          ///< angular velocity, trunk's axes
  /// Acceleration without gravity, trunk's axes: the mean over the last tick. At rest it points up with 9.81 m/s^2.
  Eigen::Vector3d specific_force_m_s2 = Eigen::Vector3d::Zero();
};

/// Readings of the sensors of the shared hydraulic supply. They are sampled every robot::Robot::supply_ticks().
struct SupplyReading {
  double pressure_Pa = 0.0;
  double pump_flow_m3_s = 0.0;  ///< mean since the reading before
};

class World {
 public:
  virtual ~World();

  virtual Tick tick() const noexcept = 0;
  virtual std::size_t joints() const noexcept = 0;

  /// Readings at the present tick. Repeated calls give the same numbers.
  virtual JointReading reading(std::size_t joint) const noexcept = 0;
  /// The same of the trunk; none in a world without one.
  virtual std::optional<ImuReading> imu() const noexcept { return std::nullopt; }

  /// The newest of the supply; none in a world without a pump.
  virtual std::optional<SupplyReading> supply() const noexcept { return std::nullopt; }

  /// Holds one command per joint over [tick, tick + 1) and moves to the next tick. A command is a valve current in A
  /// where the world has valves, else a torque in Nm. False after a failure, which is final.
  virtual bool advance(std::span<const double> commands) noexcept = 0;

  /// The reason why the world has failed, with its tick; none while it has not.
  virtual std::optional<std::string> failure() const { return std::nullopt; }

 protected:
  World() = default;
  World(const World&) = default;
  World(World&&) = default;
  World& operator=(const World&) = default;
  World& operator=(World&&) = default;
};

}  // namespace farrier::world
