#include "trials/body/actuated_robot.hpp"

#include <algorithm>
#include <utility>

#include "supervisor/first_gains.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::trials {
namespace {

constexpr std::uint64_t kSession = 1;

}  // namespace

Result<ActuatedRobot> ActuatedRobot::create(const robot::Robot& known, const robot::Robot& real,
                                            const body::Scene& scene, std::uint64_t seed, int finer) {
  auto robot = FARRIER_TRY(sim_bridge::BodyRobot::create(real, scene, seed, false, finer));
  ActuatedRobot made(known, std::move(robot));
  for (const robot::Joint& joint : known.joints) {
    FARRIER_TRY(made.design(joint, known));
  }
  return made;
}

ActuatedRobot::ActuatedRobot(const robot::Robot& known, sim_bridge::BodyRobot robot)
    : joints_(known.joints),
      robot_(std::move(robot)),
      currents_A_(joints_.size(), 0.0),
      phases_(joints_.size(), Phase::kStance) {
  for (const robot::Joint& joint : joints_) {
    nodes_.emplace_back(joint, known.safety, known.period_s, known.loop_delay_lockstep, kSession);
    nodes_.back().set_mode({.epoch = 1, .session = kSession, .effective_tick = 0, .mode = signals::Mode::kArmed});
    on_the_way_A_.emplace_back(static_cast<std::size_t>(known.loop_delay_lockstep) + 1, 0.0);
  }
}

// The gains that a supervisor without estimates gives, from the first tick on.
Result<Done> ActuatedRobot::design(const robot::Joint& joint, const robot::Robot& known) {
  if (joint.kind != control::Kind::kLqr && joint.kind != control::Kind::kFlowInversion) {
    return Done{};
  }
  const auto slots =
      FARRIER_TRY(supervisor::design_slots(joint, robot::Design::kPhases, known.period_s, known.loop_delay_lockstep));
  for (const signals::Phase phase : supervisor::kPhases) {
    constexpr std::uint32_t kAuthority = 1, kGeneration = 1;
    const control::Gains& gains = slots[static_cast<std::size_t>(phase)];
    nodes_[joint.number].store_gains(
        wire_gains::with_physics(wire_gains::pack_gains(joint.number, phase, kAuthority, kGeneration, gains),
                                 supervisor::first_physics(joint, robot::Design::kPhases, phase)),
        gains);
  }
  return Done{};
}

world::JointReading ActuatedRobot::reading(std::size_t index) const noexcept {
  const plant::Linkage& linkage = joints_[index].linkage;
  const world::JointReading read = robot_.reading(index);
  const double angle_rad = linkage.angle(read.position);
  return {angle_rad, linkage.angular_velocity(angle_rad, read.velocity), linkage.torque(angle_rad, read.force)};
}

void ActuatedRobot::track(std::size_t index, const trace::TraceRow& row, double reference) noexcept {
  const double error = row.force_N_or_Nm - reference;
  Tracking& sums = tracking_[static_cast<std::size_t>(joints_[index].index_in_leg)][row.actual_phase];
  sums.error += error * error;
  sums.reference += reference * reference;
  sums.count += 1.0;
}

void ActuatedRobot::announce_contact(std::size_t index, Phase phase) noexcept {
  if (phase != phases_[index]) {
    phases_[index] = phase;
    nodes_[index].announce_phase({.leg = static_cast<std::uint16_t>(joints_[index].leg),
                                  .count = ++contacts_,
                                  .announced_tick = tick(),
                                  .switch_tick = tick(),
                                  .phase = phase});
  }
}

bool ActuatedRobot::advance(std::span<const double> torques_Nm) noexcept {
  if (tick() == track_from_) {
    energy_before_ = robot_.actuators()->audit();
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const robot::Joint& joint = joints_[i];
    trace::TraceRow truth;
    robot_.describe(i, truth);
    announce_contact(i, truth.actual_phase);
    joint_node::JointNode::Inputs inputs;
    inputs.tick = tick();
    inputs.sensors = robot_.sample(i);
    inputs.command.joint = joint.number;
    inputs.command.tick = tick();
    inputs.command.position_rad = std::clamp(reading(i).position, joint.angle_min_rad, joint.angle_max_rad);
    inputs.command.torque_ff_Nm = torques_Nm[i];
    const signals::JointValveCommand valve = nodes_[i].step(inputs).valve;
    std::vector<double>& ring = on_the_way_A_[i];
    const auto slots = static_cast<Tick>(ring.size());
    ring[static_cast<std::size_t>(tick() % slots)] = valve.valve_current_A;
    currents_A_[i] = ring[static_cast<std::size_t>((tick() + 1) % slots)];
    if (tick() >= track_from_) {
      track(i, truth, valve.force_reference_N_or_Nm);
    }
  }
  const bool moved = robot_.advance(currents_A_);
  if (const plant::Supply* supply = robot_.actuators()->supply()) {
    least_supply_Pa_ = std::min(least_supply_Pa_, supply->pressure_Pa());
  }
  return moved;
}

}  // namespace farrier::trials
