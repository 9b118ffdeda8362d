#include "locomotion/locomotion.hpp"

#include <algorithm>

#include "participant/clock.hpp"
#include "robot/keys.hpp"

namespace farrier::locomotion {

using namespace std::chrono_literals;

Result<Locomotion::Ports> Locomotion::Ports::open(participant::Participant& participant, const robot::Robot& robot) {
  auto clock = FARRIER_TRY(participant.subscribe<signals::ClockTick>({0}));
  auto commands = FARRIER_TRY(
      participant.publish<signals::JointCommand>(robot::joint_numbers(robot), robot::legs_of_joints(robot)));
  auto phases = FARRIER_TRY(participant.publish<signals::GaitPhase>(robot::leg_numbers(robot)));
  return Ports{clock, commands, phases};
}

Locomotion::Locomotion(const robot::Robot& robot, participant::Participant& participant, Ports ports, Tick ticks)
    : robot_(robot),
      participant_(participant),
      ports_(ports),
      lockstep_(participant.identity().clock == bus::ClockKind::kLockstep),
      ticks_(ticks),
      announced_(robot.plan.legs.size(), 0) {}

std::string Locomotion::waits_for() const {
  const std::string lacking = participant_.greeting_lacks();
  if (!lacking.empty()) {
    return lacking;
  }
  return begun_ >= tick_ ? "joint/sensors and body/imu of tick " + std::to_string(tick_)
                         : "clock/tick " + std::to_string(tick_);
}

void Locomotion::announce(std::uint16_t leg, const signals::GaitPhase& phase) {
  announced_[leg] = phase.count;
  ports_.phases->publish(phase);
}

signals::JointCommand Locomotion::command_for(const robot::Joint& joint, Tick tick) const {
  signals::JointCommand command;
  command.joint = joint.number;
  command.tick = tick;
  command.sample_time_ns =
      std::chrono::duration_cast<Nanoseconds>(participant::steady_now().time_since_epoch()).count();
  command.announced_phases = announced_[static_cast<std::size_t>(joint.leg)];
  return command;
}

void Locomotion::poll(SteadyTime now) {
  ports_.clock->drain([&](const signals::ClockTick& clock) { begun_ = std::max(begun_, clock.tick); });
  drain();
  if (!participant_.started(now) || finished()) {
    return;
  }
  if (!primed_) {
    prime();
    primed_ = true;
  }
  if (begun_ >= tick_ && ready(begun_)) {
    begin(tick_, begun_);
    tick_ = begun_ + 1;
    if (lockstep_) {
      participant_.tick_done(begun_);
    }
    if (finished()) {
      participant_.report_health(tick_, true);
    }
  }
  if (!lockstep_ && now >= next_health_) {
    next_health_ = now + 100ms;
    participant_.report_health(tick_, false);
  }
}

}  // namespace farrier::locomotion
