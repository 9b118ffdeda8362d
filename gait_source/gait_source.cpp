#include "gait_source/gait_source.hpp"

#include <algorithm>

#include "gait/reference.hpp"
#include "gait/schedule.hpp"
#include "participant/clock.hpp"
#include "robot/keys.hpp"

namespace farrier::gait_source {
namespace {

using namespace std::chrono_literals;

struct Ports {
  participant::In<signals::ClockTick>* clock;
  participant::Out<signals::JointCommand>* commands;
  participant::Out<signals::GaitPhase>* phases;
};

class PlannedGait final : public GaitSource {
 public:
  PlannedGait(const robot::Robot& robot, std::uint64_t seed, Ports ports, participant::Participant& participant,
              Tick ticks, Announce announce)
      : robot_(robot),
        schedule_(robot.plan, seed),
        reference_(robot.plan),
        ports_(ports),
        participant_(participant),
        lockstep_(participant.identity().clock == bus::ClockKind::kLockstep),
        ticks_(ticks),
        announce_(announce),
        announced_(robot.plan.legs.size(), 0) {}

  void poll(SteadyTime now) override;
  bool finished() const override { return ticks_ > 0 && tick_ >= ticks_; }
  int missing() const override { return 1; }
  std::string waits_for() const override {
    const std::string lacking = participant_.greeting_lacks();
    return lacking.empty() ? "clock/tick " + std::to_string(tick_) : lacking;
  }
  Tick tick() const override { return tick_; }

 private:
  void announce(Tick tick);
  void command(Tick tick);
  void begin(Tick tick);

  const robot::Robot& robot_;
  gait::Schedule schedule_;
  gait::Reference reference_;
  Ports ports_;
  participant::Participant& participant_;
  bool lockstep_;
  Tick ticks_;
  Announce announce_;
  Tick tick_ = 0;         ///< next the clock must begin
  Tick begun_ = kNoTick;  ///< newest the clock has begun
  bool primed_ = false;   ///< what tick 0 needs is published
  std::vector<std::uint32_t> announced_;
  SteadyTime next_health_{};
};

void PlannedGait::announce(Tick tick) {
  for (std::size_t leg = 0; leg < announced_.size(); ++leg) {
    if (const auto planned = schedule_.announcement(static_cast<int>(leg), tick)) {
      announced_[leg] = planned->count;
      const Tick at =
          announce_ == Announce::kActual ? schedule_.actual_switch(static_cast<int>(leg), *planned) : planned->tick;
      ports_.phases->publish({static_cast<std::uint16_t>(leg), planned->count, tick, at, planned->phase});
    }
  }
}

void PlannedGait::command(Tick tick) {
  const auto sample_time =
      std::chrono::duration_cast<Nanoseconds>(participant::steady_now().time_since_epoch()).count();
  for (const robot::Joint& joint : robot_.joints) {
    const gait::JointReference reference = reference_.at(joint.leg, joint.index_in_leg, tick);
    signals::JointCommand command;
    command.joint = joint.number;
    command.tick = tick;
    command.sample_time_ns = sample_time;
    command.position_rad = reference.position_rad;
    command.velocity_rad_s = reference.velocity_rad_s;
    command.torque_ff_Nm = reference.torque_ff_Nm;
    command.stiffness_Nm_rad = joint.stiffness_Nm_rad;
    command.damping_Nms_rad = joint.damping_Nms_rad;
    command.announced_phases = announced_[static_cast<std::size_t>(joint.leg)];
    ports_.commands->publish(command);
  }
  ports_.commands->flush();
}

// In real time ticks may be skipped: the announcements of all of them are made, the command is for the newest.
void PlannedGait::begin(Tick tick) {
  for (; tick_ <= tick; ++tick_) {
    announce(tick_ + 1);
  }
  command(tick + 1);
  if (lockstep_) {
    participant_.tick_done(tick);
  }
}

void PlannedGait::poll(SteadyTime now) {
  ports_.clock->drain([&](const signals::ClockTick& clock) { begun_ = std::max(begun_, clock.tick); });
  if (!participant_.started(now) || finished()) {
    return;
  }
  if (!primed_) {
    announce(0);
    command(0);
    primed_ = true;
  }
  if (begun_ >= tick_) {
    begin(begun_);
    if (finished()) {
      participant_.report_health(tick_, true);
    }
  }
  if (!lockstep_ && now >= next_health_) {
    next_health_ = now + 100ms;
    participant_.report_health(tick_, false);
  }
}

}  // namespace

Result<std::unique_ptr<GaitSource>> GaitSource::create(const robot::Robot& robot, std::uint64_t seed,
                                                       participant::Participant& participant, Tick ticks,
                                                       Announce announce) {
  const std::vector<std::uint16_t> numbers = robot::joint_numbers(robot);
  auto clock = FARRIER_TRY(participant.subscribe<signals::ClockTick>({0}));
  auto commands = FARRIER_TRY(participant.publish<signals::JointCommand>(numbers, robot::legs_of_joints(robot)));
  auto phases = FARRIER_TRY(participant.publish<signals::GaitPhase>(robot::leg_numbers(robot)));
  return std::unique_ptr<GaitSource>(
      std::make_unique<PlannedGait>(robot, seed, Ports{clock, commands, phases}, participant, ticks, announce));
}

}  // namespace farrier::gait_source
