#pragma once

#include <utility>
#include <variant>

#include "plant/electric_joint.hpp"
#include "plant/hydraulic_joint.hpp"

namespace farrier::plant {

/// Readings of every joint, hydraulic or electric; m, m/s, N or rad, rad/s, Nm.
struct JointReadings {
  double position;
  double velocity;
  double load_cell_force;  ///< of an electric joint the torque sensor's
};

/// A simulated joint of either kind, with the interface that a simulation of a robot needs.
class Joint {
 public:
  explicit Joint(HydraulicJoint joint) noexcept : joint_(std::move(joint)) {}
  explicit Joint(ElectricJoint joint) noexcept : joint_(std::move(joint)) {}

  /// As the kinds' own.
  bool set_load(const LoadParams& load) noexcept {
    return std::visit([&](auto& joint) noexcept { return joint.set_load(load); }, joint_);
  }
  /// Argument `current_A`: through the valve, or the command of an electric joint's drive.
  StepReport step(double current_A, double external_force, double period_s) noexcept {
    return std::visit([&](auto& joint) noexcept { return joint.step(current_A, external_force, period_s); }, joint_);
  }
  JointReadings readings() const noexcept {
    return std::visit(
        [](const auto& joint) noexcept {
          return JointReadings{joint.state().position, joint.state().velocity, joint.load_cell_force()};
        },
        joint_);
  }
  const LoadParams& load() const noexcept {
    return std::visit([](const auto& joint) noexcept -> const LoadParams& { return joint.load(); }, joint_);
  }

  /// Null for an electric one.
  const HydraulicJoint* hydraulic() const noexcept { return std::get_if<HydraulicJoint>(&joint_); }

 private:
  std::variant<HydraulicJoint, ElectricJoint> joint_;
};

}  // namespace farrier::plant
