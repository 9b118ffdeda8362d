#pragma once

// The whole robot on a ground:
//
//   valve currents ──▶ Actuators ──▶ torques ──▶ BodyWorld ──▶ angles ──▶ linkages ──▶ SensorChain ──▶ readings.
//                          ▲                        │
//                          └──── each step's motion ┘
//
// Ideal joints have no actuators: force references go through the linkages to the body.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim_bridge/sensor_chain.hpp"
#include "sim_bridge/simulated_robot.hpp"
#include "sim_bridge/supply_meter.hpp"
#include "world/actuators.hpp"
#include "world/body_world.hpp"

namespace farrier::sim_bridge {

class BodyRobot final : public SimulatedRobot {
 public:
  /// The robot in its home pose, its joints its actuators or `ideal` sources of torque. Refuses what BodyWorld, Actuators
  /// and SensorChain refuse, and faults of a supply that ideal joints do not have.
  static Result<BodyRobot> create(const robot::Robot& robot, const body::Scene& scene, std::uint64_t seed, bool ideal,
                                  int finer = 1);

  Tick tick() const noexcept override { return world_.tick(); }
  std::size_t joints() const noexcept override { return joints_.size(); }
  bool takes_forces() const noexcept override { return !actuators_; }
  std::optional<world::ImuReading> imu() const noexcept override { return world_.imu(); }
  std::optional<std::string> failure() const override { return world_.failure(); }
  std::optional<world::SupplyReading> supply() const noexcept override;
  const signals::SupplyState* supply_state() const noexcept override { return meter_ ? &meter_->state() : nullptr; }

  std::optional<signals::SupplyTruth> supply_truth() const noexcept override;

  world::JointReading reading(std::size_t joint) const noexcept override {
    const Measured& sample = sensors_[joint].sample();
    return {sample.position, sample.velocity, sample.force};
  }

  signals::JointSensors sample(std::size_t joint) const noexcept override {
    signals::JointSensors sensors;
    sensors.joint = joints_[joint].number;
    sensors.tick = tick();
    put(sensors_[joint].sample(), sensors);
    return sensors;
  }

  bool advance(std::span<const double> commands) noexcept override;
  void describe(std::size_t joint, trace::TraceRow& row) const noexcept override;
  std::optional<signals::BodyTruth> truth() const noexcept override;

  /// The truth. Only reports, trials and tests read it.
  const world::BodyWorld& body() const noexcept { return world_; }
  /// Null where the joints are ideal.
  const world::Actuators* actuators() const noexcept { return actuators_ ? &*actuators_ : nullptr; }

 private:
  BodyRobot(const robot::Robot& robot, world::BodyWorld world, std::optional<world::Actuators> actuators,
            std::vector<SensorChain> sensors);
  Measured truth_of_joint(std::size_t index) const noexcept;
  bool move(std::span<const double> commands) noexcept;

  std::vector<robot::Joint> joints_;
  double period_s_;
  world::BodyWorld world_;
  std::optional<world::Actuators> actuators_;
  std::vector<SensorChain> sensors_;  // by joint
  std::vector<double> torques_Nm_;
  std::vector<Measured> before_;  // truth of the last tick, by joint
  std::optional<SupplyMeter> meter_;
  Tick supply_ticks_;  // between its samples
};

}  // namespace farrier::sim_bridge
