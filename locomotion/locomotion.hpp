#pragma once

// The process that commands all joints:
//
//   clock/tick ──▶ plays the robot file's gait (gait_source.hpp), or
//   clock/tick, joint/sensors, body/imu, body/command ──▶ a controller of the whole robot (body_locomotion.hpp)
//                                                  ──▶ joint/command, gait/phase, body/state.
//
// When tick k begins it publishes the commands for tick k + 1, so it is never on the path from sensor to valve.

#include <memory>

#include "participant/application.hpp"
#include "participant/participant.hpp"
#include "robot/robot.hpp"

namespace farrier::locomotion {

/// The common part of both kinds: the clock, and the ports of commands and announcements.
class Locomotion : public participant::Application {
 public:
  void poll(SteadyTime now) final;
  bool finished() const final { return ticks_ > 0 && tick_ >= ticks_; }
  int missing() const override { return 1; }
  std::string waits_for() const override;

  /// Ticks whose commands were asked for so far.
  Tick tick() const noexcept { return tick_; }

 protected:
  struct Ports {
    participant::In<signals::ClockTick>* clock;
    participant::Out<signals::JointCommand>* commands;
    participant::Out<signals::GaitPhase>* phases;

    static Result<Ports> open(participant::Participant& participant, const robot::Robot& robot);
  };

  /// `ticks` 0: until told to stop.
  Locomotion(const robot::Robot& robot, participant::Participant& participant, Ports ports, Tick ticks);

  /// Publishes what tick 0 needs.
  virtual void prime() = 0;
  /// Takes in what has arrived beside the clock.
  virtual void drain() {}
  /// True if all is there that begin(tick) needs. In real time the newest samples do.
  virtual bool ready(Tick) const { return true; }
  /// Publishes what tick + 1 needs. In real time ticks may be skipped: then `first` < `tick`.
  virtual void begin(Tick first, Tick tick) = 0;

  /// Announces a change of phase with the tick that the announcement belongs to.
  void announce(std::uint16_t leg, const signals::GaitPhase& phase);
  /// A command of the joint for that tick. The sender fills in the rest.
  signals::JointCommand command_for(const robot::Joint& joint, Tick tick) const;

  const robot::Robot& robot() const noexcept { return robot_; }
  participant::Participant& participant() noexcept { return participant_; }
  const participant::Participant& participant() const noexcept { return participant_; }
  const Ports& ports() const noexcept { return ports_; }
  bool lockstep() const noexcept { return lockstep_; }

 private:
  const robot::Robot& robot_;
  participant::Participant& participant_;
  Ports ports_;
  bool lockstep_;
  Tick ticks_;
  Tick tick_ = 0;         ///< next the clock must begin
  Tick begun_ = kNoTick;  ///< newest the clock has begun
  bool primed_ = false;
  std::vector<std::uint32_t> announced_;  ///< by leg
  SteadyTime next_health_{};
};

}  // namespace farrier::locomotion
