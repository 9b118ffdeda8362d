#include "locomotion/gait_source.hpp"

#include "gait/reference.hpp"
#include "gait/schedule.hpp"

namespace farrier::locomotion {
namespace {

class PlannedGait final : public Locomotion {
 public:
  static Result<std::unique_ptr<Locomotion>> create(const robot::Robot& robot, std::uint64_t seed,
                                                    participant::Participant& participant, Tick ticks, Announce kind) {
    const Ports ports = FARRIER_TRY(Ports::open(participant, robot));
    return std::unique_ptr<Locomotion>(new PlannedGait(robot, seed, ports, participant, ticks, kind));
  }

 private:
  PlannedGait(const robot::Robot& robot, std::uint64_t seed, Ports ports, participant::Participant& participant,
              Tick ticks, Announce kind)
      : Locomotion(robot, participant, ports, ticks),
        schedule_(robot.plan, seed),
        reference_(robot.plan),
        announce_(kind) {}

  void prime() override {
    announce_switches(0);
    command(0);
  }
  void begin(Tick first, Tick tick) override;
  void announce_switches(Tick tick);
  void command(Tick tick);

  gait::Schedule schedule_;
  gait::Reference reference_;
  Announce announce_;
};

void PlannedGait::announce_switches(Tick tick) {
  for (std::size_t leg = 0; leg < robot().plan.legs.size(); ++leg) {
    if (const auto planned = schedule_.announcement(static_cast<int>(leg), tick)) {
      const Tick at =
          announce_ == Announce::kActual ? schedule_.actual_switch(static_cast<int>(leg), *planned) : planned->tick;
      const auto number = static_cast<std::uint16_t>(leg);
      announce(number, {number, planned->count, tick, at, planned->phase, 0});
    }
  }
}

void PlannedGait::command(Tick tick) {
  for (const robot::Joint& joint : robot().joints) {
    const gait::JointReference reference = reference_.at(joint.leg, joint.index_in_leg, tick);
    signals::JointCommand command = command_for(joint, tick);
    command.position_rad = reference.position_rad;
    command.velocity_rad_s = reference.velocity_rad_s;
    command.torque_ff_Nm = reference.torque_ff_Nm;
    command.stiffness_Nm_rad = joint.stiffness_Nm_rad;
    command.damping_Nms_rad = joint.damping_Nms_rad;
    ports().commands->publish(command);
  }
  ports().commands->flush();
}

// The announcements of skipped ticks are made, the command is for the newest.
void PlannedGait::begin(Tick first, Tick tick) {
  for (Tick each = first; each <= tick; ++each) {
    announce_switches(each + 1);
  }
  command(tick + 1);
}

}  // namespace

Result<std::unique_ptr<Locomotion>> create_gait_source(const robot::Robot& robot, std::uint64_t seed,
                                                       participant::Participant& participant, Tick ticks,
                                                       Announce announce) {
  return PlannedGait::create(robot, seed, participant, ticks, announce);
}

}  // namespace farrier::locomotion
