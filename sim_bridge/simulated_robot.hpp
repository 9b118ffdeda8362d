#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robot/load_change.hpp"
#include "robot/robot.hpp"
#include "signals/signals.hpp"
#include "trace/trace.hpp"
#include "world/world.hpp"

namespace farrier::sim_bridge {

/// A world in the terms of sim_bridge. Each joint's coordinates are those of its actuator.
class SimulatedRobot : public world::World {
 public:
  /// Readings of a joint as a sample of the present tick.
  virtual signals::JointSensors sample(std::size_t joint) const noexcept = 0;

  /// Fills the trace's row of one joint at the present tick, before advance(); controller fields are left unchanged.
  virtual void describe(std::size_t joint, trace::TraceRow& row) const noexcept = 0;

  /// True if the commands of advance() are force references in N or Nm, which ideal joints follow at once; else they are
  /// valve currents in A.
  virtual bool takes_forces() const noexcept { return false; }

  /// The true state of the body at the present tick; none on a bench.
  virtual std::optional<signals::BodyTruth> truth() const noexcept { return std::nullopt; }

  /// The newest sample of the shared supply; none without a pump.
  virtual const signals::SupplyState* supply_state() const noexcept { return nullptr; }

  /// True pressures in the actuators and the account of the pump's work at the present tick; none without a pump.
  virtual std::optional<signals::SupplyTruth> supply_truth() const noexcept { return std::nullopt; }
};

/// Refuses a simulated robot without a pump in place of one with it, whose processes wait for supply/state.
Result<Done> check_supply(const robot::Robot& known, const robot::Robot& simulated);

/// The bench: each joint by itself on a load that changes with the phase (SimWorld).
Result<std::unique_ptr<SimulatedRobot>> simulated_bench(const robot::Robot& robot, std::uint64_t seed,
                                                        std::vector<robot::LoadChange> load_changes = {});

/// True if this build has the physics engine of simulated_body().
bool has_physics_engine() noexcept;

/// The whole robot on the ground of a scene file, its joints its actuators or `ideal` sources of torque. An empty path is
/// a plane. Refuses a robot without a trunk or with actuators that cannot be simulated, a scene with mistakes, and a
/// build without the physics engine.
Result<std::unique_ptr<SimulatedRobot>> simulated_body(const robot::Robot& robot, const std::string& scene_path,
                                                       std::uint64_t seed, bool ideal);

}  // namespace farrier::sim_bridge
