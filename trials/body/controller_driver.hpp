#pragma once

#include <vector>

#include "locomotion/controller.hpp"
#include "trials/body/body_trial.hpp"
#include "locomotion/motion_script.hpp"

namespace farrier::trials {

/// Drives a world by a controller of lib/locomotion, tick by tick, as its process would. Torques that answer the
/// readings of tick k act in tick k + 1 + lag_ticks.
class ControllerDriver final : public BodyController {
 public:
  /// `controller` must outlive the driver. `script` is sorted by time; before its first command the robot shall lie.
  ControllerDriver(locomotion::Controller& controller, std::vector<locomotion::TimedCommand> script, double period_s,
                   int lag_ticks = 0);

  void step(const world::World& world, std::span<double> torques_Nm) noexcept override;

 private:
  void read(const world::World& world) noexcept;
  locomotion::MotionCommand command_at(Tick tick) const noexcept;

  locomotion::Controller& controller_;
  std::vector<locomotion::TimedCommand> script_;
  double period_s_;
  locomotion::Readings readings_;
  std::vector<locomotion::LegTorques> on_the_way_;  // a ring
  std::size_t next_ = 0;
};

}  // namespace farrier::trials
