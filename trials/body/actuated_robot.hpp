#pragma once

// A robot whose actuators follow torques, as its processes have them:
//
//   torques ──▶ JointNode of each joint ──▶ valve currents ──▶ BodyRobot ──▶ samples ──▶ angles, velocities, torques.
//                    ▲                                             │
//                    └───────────────── samples ◀──────────────────┘

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "gait/late_touchdowns.hpp"
#include "gait/schedule.hpp"
#include "joint_node/joint_node.hpp"
#include "sim_bridge/body_robot.hpp"
#include "trials/body/joint_adaptation.hpp"
#include "world/world.hpp"

namespace farrier::trials {

/// Changes of phase that joints were told, and how well they match the feet.
struct GainSwitches {
  int planned = 0, felt = 0;
  int late_touchdowns = 0;      ///< as gait::LateTouchdowns counts them
  double late_s = 0.0;          ///< sum over these
  double largest_late_s = 0.0;  ///< of one touchdown
};

/// The same robots, scene, seed and torques give the same numbers bit for bit.
class ActuatedRobot final : public world::World {
 public:
  /// The joints' nodes have the model of `known`, the simulation that of `real`; both have the same joints. Controllers
  /// that take gains have the designs for the loads of both phases. Refuses what these designs and BodyRobot::create do.
  /// With `adapts` estimators and a supervisor of the known robot redesign them. With `knows` controllers that take
  /// physics have those of the worn actuators at once: perfect knowledge of what a scene changes.
  static Result<ActuatedRobot> create(const robot::Robot& known, const robot::Robot& real, const body::Scene& scene,
                                      std::uint64_t seed, int finer = 1, bool adapts = false, bool knows = false);

  Tick tick() const noexcept override { return robot_.tick(); }
  std::size_t joints() const noexcept override { return robot_.joints(); }
  /// Angle, velocity and torque of the joint, by its actuator's sensors.
  world::JointReading reading(std::size_t joint) const noexcept override;
  std::optional<world::ImuReading> imu() const noexcept override { return robot_.imu(); }
  std::optional<world::SupplyReading> supply() const noexcept override { return robot_.supply(); }
  std::optional<std::string> failure() const override { return robot_.failure(); }
  /// The commands are torques, Nm. A valve's current acts loop_delay_lockstep ticks after the samples that it answers.
  bool advance(std::span<const double> torques_Nm) noexcept override {
    decide(torques_Nm);
    return move();
  }
  /// The part of advance() that a robot computes itself: force control and, where it adapts, estimates and redesign.
  void decide(std::span<const double> torques_Nm) noexcept;
  /// The part that is simulated.
  bool move() noexcept;

  const sim_bridge::BodyRobot& robot() const noexcept { return robot_; }

  /// Sums of squares of a joint's force error and reference in a phase, N^2 or (Nm)^2, and their number.
  struct Tracking {
    double error = 0.0, reference = 0.0, count = 0.0;
  };
  /// The sums of all joints at one place of a leg, from `begin` of track_from() on; the phase is that of the leg's foot.
  const PerPhase<Tracking>& tracking(std::size_t place) const noexcept { return tracking_[place]; }
  void track_from(Tick begin) noexcept { track_from_ = begin; }
  /// Tells the joints of a leg a change of phase, at the tick in which the message arrives.
  void announce(int leg, const gait::PhaseSwitch& change) noexcept;
  GainSwitches switches() const noexcept;
  /// Gets the measurement of each joint at each tick, with the true state at that tick. Set before the first tick.
  using Listener = std::function<void(const signals::JointMeasurement&, const trace::TraceRow&)>;
  void listen(Listener listener) { listener_ = std::move(listener); }
  /// Empty for a robot that does not adapt.
  std::optional<AdaptationCounts> adaptation() const noexcept {
    return adaptation_ ? std::optional(adaptation_->counts()) : std::nullopt;
  }
  /// The account of the pump's work since that tick.
  world::EnergyAudit energy() const noexcept { return robot_.actuators()->audit() - energy_before_; }
  /// Least pressure of the supply at the ticks so far; infinite without a pump.
  double least_supply_Pa() const noexcept { return least_supply_Pa_; }

 private:
  ActuatedRobot(const robot::Robot& known, sim_bridge::BodyRobot robot);
  Result<Done> design(const robot::Joint& joint, const robot::Robot& known);
  void track(std::size_t joint, const trace::TraceRow& truth, double reference) noexcept;

  void store(const std::vector<signals::JointControllerGains>& gains) noexcept;
  void tell_wear();

  std::vector<robot::Joint> joints_;
  sim_bridge::BodyRobot robot_;
  std::vector<joint_node::JointNode> nodes_;
  std::vector<std::vector<double>> on_the_way_A_;  // rings of currents, by joint
  std::vector<double> currents_A_;
  double period_s_;
  GainSwitches switches_;                   // without those of late_
  std::vector<gait::LateTouchdowns> late_;  // by leg
  std::array<PerPhase<Tracking>, body::kJointsPerLeg> tracking_{};
  Listener listener_;
  std::optional<JointAdaptation> adaptation_;
  bool knows_ = false;
  std::vector<robot::Wear> told_;  // by joint
  std::uint32_t generation_ = 1;
  Tick track_from_ = 0;
  world::EnergyAudit energy_before_;
  double least_supply_Pa_ = std::numeric_limits<double>::infinity();
};

}  // namespace farrier::trials
