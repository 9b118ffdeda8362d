#pragma once

// The actuators of a robot on a ground, and the supply that they share:
//
//   valve currents ──▶ actuators ──▶ forces ──▶ linkages ──▶ torques ──▶ a step of the body
//                        ▲   ▲                                             │
//                        │   └── displacement that was really made ◀───────┘
//                        └── pressure ── supply ◀── oil drawn.
//
// The body moves first, under the forces of the present state; then the oil follows the displacement. This is symplectic
// Euler between oil and body: the error of the energy is bounded and goes with the length of the step.

#include <optional>
#include <span>
#include <vector>

#include "body/scene/scene.hpp"
#include "plant/joint.hpp"
#include "plant/supply.hpp"
#include "robot/robot.hpp"
#include "robot/wear.hpp"
#include "world/energy_audit.hpp"
#include "world/joint_drives.hpp"

namespace farrier::world {

/// Energies since the start, J.
struct ActuatorEnergies {
  plant::OilAccount oil;    ///< of all hydraulic actuators
  double electric_J = 0.0;  ///< drawn by electric ones
  double work_J = 0.0;      ///< done on the body: sum of force times displacement really made
  double coupling_J = 0.0;  ///< by which that exceeds the actuators' own
};

/// The same robot, currents and motion give the same numbers bit for bit.
class Actuators final : public JointDrives {
 public:
  /// At rest at the home pose, valves shut, the supply full. Without a pump in the file the supply has its nominal
  /// pressure. Refuses actuators that cannot be simulated, naming the joint, and changes of a supply without a pump or
  /// of an accumulator without a precharge, with their line.
  /// Refuses likewise a change of a joint that the robot does not have, that is electric, or that cannot be simulated.
  static Result<Actuators> create(const robot::Robot& robot, std::vector<body::SupplyChange> supply_changes = {},
                                  std::vector<body::ActuatorChange> actuator_changes = {});

  /// Holds one current per joint, A, until the next call. Changes of supply and actuators that have begun at `time_s` act
  /// from here on; one that grows does so in steps of 10 ms.
  void command(std::span<const double> currents_A, double time_s = 0.0) noexcept;

  const body::JointVector& torques_Nm() const noexcept override { return torques_Nm_; }
  void follow(const body::BodyState& state, double step_s) noexcept override;

  const plant::Joint& joint(std::size_t index) const noexcept { return joints_[index].plant; }
  /// Wear of a joint's actuator now.
  const robot::Wear& wear(std::size_t index) const noexcept { return joints_[index].wear; }
  /// Null without a pump in the file.
  const plant::Supply* supply() const noexcept { return supply_ ? &*supply_ : nullptr; }
  const ActuatorEnergies& energies() const noexcept { return energies_; }
  /// Energy in the oil of all actuators, J.
  double stored_J() const noexcept;
  /// The account of the pump's work since the start; zero without a pump.
  EnergyAudit audit() const noexcept;

 private:
  struct Joint {
    plant::Linkage linkage;
    plant::Joint plant;
    double current_A = 0.0;
    double force = 0.0;  ///< on the body at the present state, N or Nm
    robot::Wear wear{};
  };
  /// A change of one joint's actuator that has not ended.
  struct Change {
    std::size_t joint;
    double start_s, duration_s;
    body::ActuatorChange to;
    std::optional<robot::Wear> from = std::nullopt;  ///< when it began
  };

  Actuators(std::vector<Joint> joints, const std::optional<plant::Supply>& supply,
            std::vector<body::SupplyChange> supply_changes, std::vector<Change> changes, const robot::Robot& robot,
            const body::JointVector& angles_rad);
  static Result<std::vector<Change>> changes_of(const robot::Robot& robot,
                                                std::vector<body::ActuatorChange> actuator_changes);
  void wear_out(double time_s) noexcept;
  /// The force of the present state, and its torque.
  void set_force(std::size_t index, double angle_rad) noexcept;

  std::vector<Joint> joints_;
  std::optional<plant::Supply> supply_;
  std::vector<body::SupplyChange> supply_changes_;  // in the order of their times
  std::size_t next_change_ = 0;
  std::vector<robot::Joint> as_in_file_;  // empty without changes of actuators
  std::vector<Change> changes_;           // in the order of their times
  double worn_until_s_ = 0.0;
  body::JointVector torques_Nm_;
  ActuatorEnergies energies_;
  double oil_at_start_J_ = 0.0, supply_at_start_J_ = 0.0;  ///< stored
};

}  // namespace farrier::world
