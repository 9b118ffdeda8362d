#pragma once

// A robot whose actuators follow torques, as its processes have them:
//
//   torques ──▶ JointNode of each joint ──▶ valve currents ──▶ BodyRobot ──▶ samples ──▶ angles, velocities, torques.
//                    ▲                                             │
//                    └───────────────── samples ◀──────────────────┘

#include <array>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "joint_node/joint_node.hpp"
#include "sim_bridge/body_robot.hpp"
#include "world/world.hpp"

namespace farrier::trials {

/// The same robots, scene, seed and torques give the same numbers bit for bit.
class ActuatedRobot final : public world::World {
 public:
  /// The joints' nodes have the model of `known`, the simulation that of `real`; both have the same joints. Controllers
  /// that take gains have the designs for the loads of both phases. Refuses what these designs and BodyRobot::create do.
  static Result<ActuatedRobot> create(const robot::Robot& known, const robot::Robot& real, const body::Scene& scene,
                                      std::uint64_t seed, int finer = 1);

  Tick tick() const noexcept override { return robot_.tick(); }
  std::size_t joints() const noexcept override { return robot_.joints(); }
  /// Angle, velocity and torque of the joint, by its actuator's sensors.
  world::JointReading reading(std::size_t joint) const noexcept override;
  std::optional<world::ImuReading> imu() const noexcept override { return robot_.imu(); }
  std::optional<world::SupplyReading> supply() const noexcept override { return robot_.supply(); }
  std::optional<std::string> failure() const override { return robot_.failure(); }
  /// The commands are torques, Nm. A valve's current acts loop_delay_lockstep ticks after the samples that it answers.
  bool advance(std::span<const double> torques_Nm) noexcept override;

  const sim_bridge::BodyRobot& robot() const noexcept { return robot_; }

  /// Sums of squares of a joint's force error and reference in a phase, N^2 or (Nm)^2, and their number.
  struct Tracking {
    double error = 0.0, reference = 0.0, count = 0.0;
  };
  /// The sums of all joints at one place of a leg, from `begin` of track_from() on; the phase is that of the leg's foot.
  const PerPhase<Tracking>& tracking(std::size_t place) const noexcept { return tracking_[place]; }
  void track_from(Tick begin) noexcept { track_from_ = begin; }
  /// The account of the pump's work since that tick.
  world::EnergyAudit energy() const noexcept { return robot_.actuators()->audit() - energy_before_; }
  /// Least pressure of the supply at the ticks so far; infinite without a pump.
  double least_supply_Pa() const noexcept { return least_supply_Pa_; }

 private:
  ActuatedRobot(const robot::Robot& known, sim_bridge::BodyRobot robot);
  Result<Done> design(const robot::Joint& joint, const robot::Robot& known);
  /// Tells a joint at once that the contact of its foot has changed.
  void announce_contact(std::size_t joint, Phase phase) noexcept;
  void track(std::size_t joint, const trace::TraceRow& truth, double reference) noexcept;

  std::vector<robot::Joint> joints_;
  sim_bridge::BodyRobot robot_;
  std::vector<joint_node::JointNode> nodes_;
  std::vector<std::vector<double>> on_the_way_A_;  // rings of currents, by joint
  std::vector<double> currents_A_;
  std::vector<Phase> phases_;  // that the joints were told, by joint
  std::uint32_t contacts_ = 0;
  std::array<PerPhase<Tracking>, body::kJointsPerLeg> tracking_{};
  Tick track_from_ = 0;
  world::EnergyAudit energy_before_;
  double least_supply_Pa_ = std::numeric_limits<double>::infinity();
};

}  // namespace farrier::trials
