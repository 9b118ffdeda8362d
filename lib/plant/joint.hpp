#pragma once

#include <optional>
#include <span>
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

/// Exchange of an actuator while it follows a mechanism, m^3 and J.
struct DriveAccount {
  OilAccount oil;           ///< zero of an electric one
  double electric_J = 0.0;  ///< drawn from its supply; zero of a hydraulic one
  double work_J = 0.0;      ///< done on the mechanism
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
  /// As HydraulicJoint's; an electric joint has none and keeps its own.
  bool set_actuator(const ActuatorParams& actuator, std::span<const ActiveEffect> effects) noexcept {
    auto* oil = std::get_if<HydraulicJoint>(&joint_);
    return oil != nullptr && oil->set_actuator(actuator, effects);
  }
  /// Argument `current_A`: through the valve, or the command of an electric joint's drive.
  StepReport step(double current_A, double external_force, double period_s) noexcept {
    return std::visit([&](auto& joint) noexcept { return joint.step(current_A, external_force, period_s); }, joint_);
  }
  /// The same with the motion prescribed, see the kinds' own; an absent pressure is the nominal one, which an electric
  /// joint does not heed.
  DriveAccount follow(double current_A, std::optional<double> supply_Pa, const Motion& end, double period_s) noexcept {
    DriveAccount account;
    if (auto* oil = std::get_if<HydraulicJoint>(&joint_)) {
      oil->follow(current_A, supply_Pa.value_or(oil->actuator().supply_pressure_Pa), end, period_s, account.oil);
      account.work_J = account.oil.work_J;
    } else {
      ElectricAccount electric;
      std::get<ElectricJoint>(joint_).follow(current_A, end, period_s, electric);
      account.electric_J = electric.drawn_J;
      account.work_J = electric.work_J;
    }
    return account;
  }
  /// Force on a mechanism that follow() moves, N or Nm.
  double mechanism_force() const noexcept {
    return std::visit([](const auto& joint) noexcept { return joint.mechanism_force(); }, joint_);
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
