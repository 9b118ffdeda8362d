#pragma once

#include <optional>
#include <vector>

#include "locomotion/controller.hpp"
#include "trials/body/actuated_robot.hpp"
#include "trials/body/body_trial.hpp"
#include "locomotion/motion_script.hpp"
#include "locomotion/supply_guard.hpp"

namespace farrier::trials {

/// Drives a world by a controller of lib/locomotion, tick by tick, as its process would. Torques that answer the
/// readings of tick k act in tick k + 1 + lag_ticks.
class ControllerDriver final : public BodyController {
 public:
  /// `controller` must outlive the driver. `script` is sorted by time; before its first command the robot shall lie.
  ControllerDriver(locomotion::Controller& controller, std::vector<locomotion::TimedCommand> script, double period_s,
                   int lag_ticks = 0);

  /// From now on a guard stands between script and controller, as in locomotion's process.
  void guard_supply(const locomotion::SupplyGuardParams& limits) { guard_.emplace(limits, period_s_); }
  locomotion::SupplyDemand demand() const noexcept {
    return guard_ ? guard_->demand() : locomotion::SupplyDemand::kNone;
  }

  /// From now on a robot is told the changes of phase that the controller announces, as late as its torques.
  void tell_phases(ActuatedRobot& robot) { told_ = &robot; }

  void step(const world::World& world, std::span<double> torques_Nm) noexcept override;

 private:
  /// Torques and changes of phase of one tick.
  struct Orders {
    locomotion::LegTorques torques_Nm;
    locomotion::PerLeg<std::optional<gait::PhaseSwitch>> phases;
  };

  void read(const world::World& world) noexcept;
  locomotion::MotionCommand command_of(const world::World& world) noexcept;

  locomotion::Controller& controller_;
  std::vector<locomotion::TimedCommand> script_;
  double period_s_;
  locomotion::Readings readings_;
  std::vector<Orders> on_the_way_;  // a ring
  std::size_t next_ = 0;
  std::optional<locomotion::SupplyGuard> guard_;
  ActuatedRobot* told_ = nullptr;
};

}  // namespace farrier::trials
