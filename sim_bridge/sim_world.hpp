#pragma once

// The simulated robot:
//
//   valve currents ──▶ plant::Joint ◀── load by phase or load change, weight
//                            │ with its effects
//                            │ truth of each channel
//                            ▼
//   sensors ◀── SensorChain: effects of sensors, noise (seeded by joint name, addressed by tick), filters.
//
// Each joint of the robot file has one simulated joint, hydraulic or electric, and a bench load. The load is that of
// the leg's actual phase or of a load change.

#include <memory>
#include <vector>

#include "gait/leg_kinematics.hpp"
#include "gait/reference.hpp"
#include "gait/schedule.hpp"
#include "plant/joint.hpp"
#include "trace/trace.hpp"
#include "robot/load_change.hpp"
#include "robot/robot.hpp"
#include "sim_bridge/sensor_chain.hpp"
#include "sim_bridge/simulated_robot.hpp"
#include "signals/signals.hpp"

namespace farrier::sim_bridge {

/// The bench as a world. The same robot, seed and valve currents give the same numbers bit for bit.
class SimWorld final : public SimulatedRobot {
 public:
  /// Every joint begins at rest at its home pose. A joint with `load_changes` (any order; of two at one tick the later
  /// in the list) has the load of its actual phase until the first and that of the newest from then on. Refuses a robot
  /// whose joints cannot be simulated, and loads no joint can carry, naming the joint.
  static Result<SimWorld> create(const robot::Robot& robot, std::uint64_t seed,
                                 std::vector<robot::LoadChange> load_changes = {});

  world::JointReading reading(std::size_t joint) const noexcept override;

  signals::JointSensors sample(std::size_t joint) const noexcept override;

  /// The commands are valve currents. The bench never fails.
  bool advance(std::span<const double> valve_current_A) noexcept override;

  void describe(std::size_t joint, trace::TraceRow& row) const noexcept override;

  Tick tick() const noexcept override { return tick_; }
  std::size_t joints() const noexcept override { return joints_.size(); }

  /// Largest error the integrator stated for one step of any joint so far, relative to its tolerance scales.
  const plant::StepReport& worst_step() const noexcept { return worst_; }

 private:
  struct Joint {
    robot::Joint parameters;
    plant::Joint plant;
    SensorChain sensors;
    gait::Phase load_phase;
    double external_force;
    bool load_ruled;  ///< by a load change
  };

  SimWorld(const robot::Robot& robot, std::uint64_t seed);
  void apply_loads() noexcept;
  void step(Joint& joint, double valve_current_A) noexcept;
  void apply_load_changes() noexcept;

  gait::RobotPlan plan_;
  gait::Schedule schedule_;
  gait::Reference reference_;
  std::vector<Joint> joints_;
  std::vector<robot::LoadChange> load_changes_;  // in the order of their ticks
  std::size_t next_load_change_ = 0;
  plant::StepReport worst_;
  Tick tick_ = 0;
};

}  // namespace farrier::sim_bridge
