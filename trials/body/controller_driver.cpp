#include "trials/body/controller_driver.hpp"

#include <utility>

namespace farrier::trials {
namespace {

locomotion::LegTorques no_torques() {
  locomotion::LegTorques torques;
  torques.fill(Eigen::Vector3d::Zero());
  return torques;
}

}  // namespace

ControllerDriver::ControllerDriver(locomotion::Controller& controller, std::vector<locomotion::TimedCommand> script,
                                   double period_s, int lag_ticks)
    : controller_(controller),
      script_(std::move(script)),
      period_s_(period_s),
      on_the_way_(static_cast<std::size_t>(lag_ticks) + 1, Orders{.torques_Nm = no_torques(), .phases = {}}) {}

void ControllerDriver::read(const world::World& world) noexcept {
  for (std::size_t joint = 0; joint < world.joints(); ++joint) {
    const world::JointReading reading = world.reading(joint);
    locomotion::LegReadings& leg = readings_.legs[joint / locomotion::kJointsPerLeg];
    const auto index = static_cast<Eigen::Index>(joint % locomotion::kJointsPerLeg);
    leg.position_rad[index] = reading.position;
    leg.velocity_rad_s[index] = reading.velocity;
    leg.torque_Nm[index] = reading.force;
  }
  if (const auto imu = world.imu()) {
    readings_.imu = {.angular_velocity_rad_s = imu->rate_rad_s, .specific_force_m_s2 = imu->specific_force_m_s2};
  }
}

locomotion::MotionCommand ControllerDriver::command_of(const world::World& world) noexcept {
  const auto asked = locomotion::command_at(script_, static_cast<double>(world.tick()) * period_s_);
  if (!guard_) {
    return asked;
  }
  const auto supply = world.supply();
  return guard_->step(
      asked,
      supply ? std::optional<locomotion::SupplyReading>({supply->pressure_Pa, supply->pump_flow_m3_s}) : std::nullopt);
}

void ControllerDriver::step(const world::World& world, std::span<double> torques_Nm) noexcept {
  read(world);
  Orders& place = on_the_way_[next_];
  const Orders arriving = place;
  place.torques_Nm = controller_.step(world.tick(), readings_, command_of(world));
  for (std::size_t leg = 0; leg < place.phases.size(); ++leg) {
    const bool there = leg * locomotion::kJointsPerLeg < world.joints();
    place.phases[leg] = there ? controller_.announcement(static_cast<int>(leg)) : std::nullopt;
    if (told_ != nullptr && arriving.phases[leg]) {
      told_->announce(static_cast<int>(leg), *arriving.phases[leg]);
    }
  }
  next_ = (next_ + 1) % on_the_way_.size();
  for (std::size_t joint = 0; joint < torques_Nm.size(); ++joint) {
    torques_Nm[joint] = arriving.torques_Nm[joint / locomotion::kJointsPerLeg]
                                           [static_cast<Eigen::Index>(joint % locomotion::kJointsPerLeg)];
  }
}

}  // namespace farrier::trials
