#include "trials/body/actuated_robot.hpp"

#include <algorithm>
#include <utility>

#include "joint_node/gains_check.hpp"
#include "supervisor/first_gains.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::trials {
namespace {

constexpr std::uint64_t kSession = 1;

}  // namespace

Result<ActuatedRobot> ActuatedRobot::create(const robot::Robot& known, const robot::Robot& real,
                                            const body::Scene& scene, std::uint64_t seed, int finer, bool adapts,
                                            bool knows) {
  auto robot = FARRIER_TRY(sim_bridge::BodyRobot::create(real, scene, seed, false, finer));
  ActuatedRobot made(known, std::move(robot));
  if (adapts) {
    made.adaptation_.emplace(FARRIER_TRY(JointAdaptation::create(known, kSession)));
    return made;
  }
  for (const robot::Joint& joint : known.joints) {
    FARRIER_TRY(made.design(joint, known));
    made.told_.push_back(robot::no_wear(joint));
  }
  made.knows_ = knows;
  return made;
}

ActuatedRobot::ActuatedRobot(const robot::Robot& known, sim_bridge::BodyRobot robot)
    : joints_(known.joints),
      robot_(std::move(robot)),
      currents_A_(joints_.size(), 0.0),
      period_s_(known.period_s),
      late_(known.plan.legs.size()) {
  for (const robot::Joint& joint : joints_) {
    nodes_.emplace_back(joint, known.safety, known.period_s, known.loop_delay_lockstep, kSession);
    nodes_.back().set_mode({.epoch = 1, .session = kSession, .effective_tick = 0, .mode = signals::Mode::kArmed});
    on_the_way_A_.emplace_back(static_cast<std::size_t>(known.loop_delay_lockstep) + 1, 0.0);
  }
}

// The gains that a supervisor without estimates gives, from the first tick on.
Result<Done> ActuatedRobot::design(const robot::Joint& joint, const robot::Robot& known) {
  if (joint.kind != control::Kind::kLqr && !control::takes_physics(joint.kind)) {
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

void ActuatedRobot::announce(int leg, const gait::PhaseSwitch& change) noexcept {
  ++(change.felt ? switches_.felt : switches_.planned);
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (joints_[i].leg == leg) {
      nodes_[i].announce_phase({.leg = static_cast<std::uint16_t>(leg),
                                .count = change.count,
                                .announced_tick = tick(),
                                .switch_tick = change.tick,
                                .phase = change.phase,
                                .felt = static_cast<std::uint8_t>(change.felt ? 1 : 0)});
    }
  }
}

GainSwitches ActuatedRobot::switches() const noexcept {
  GainSwitches all = switches_;
  const gait::LateTotal late = gait::total_of(late_, period_s_);
  all.late_touchdowns = late.count;
  all.late_s = late.sum;
  all.largest_late_s = late.largest;
  return all;
}

void ActuatedRobot::store(const std::vector<signals::JointControllerGains>& gains) noexcept {
  for (const signals::JointControllerGains& signal : gains) {
    if (joint_node::check_gains(signal, joints_[signal.joint].kind)) {
      nodes_[signal.joint].store_gains(signal, wire_gains::unpack_gains(signal));
    } else {
      nodes_[signal.joint].refuse_gains(signal);
      adaptation_->refused_by_joint();
    }
  }
}

// The new physics act from this tick on, under a generation of their own.
void ActuatedRobot::tell_wear() {
  constexpr std::uint32_t kAuthority = 1;
  for (const robot::Joint& joint : joints_) {
    const robot::Wear& wear = robot_.actuators()->wear(joint.number);
    if (wear == told_[joint.number] || !control::takes_physics(joint.kind)) {
      continue;
    }
    told_[joint.number] = wear;
    ++generation_;
    const robot::Joint worn = robot::worn(joint, wear);
    for (const signals::Phase phase : supervisor::kPhases) {
      const control::Gains none{};
      plant::JointPhysics physics = supervisor::first_physics(worn, robot::Design::kPhases, phase);
      physics.leakage = wear.leakage;
      signals::JointControllerGains signal =
          wire_gains::with_physics(wire_gains::pack_gains(joint.number, phase, kAuthority, generation_, none), physics);
      signal.effective_tick = tick();
      nodes_[joint.number].store_gains(signal, none);
    }
  }
}

void ActuatedRobot::decide(std::span<const double> torques_Nm) noexcept {
  if (tick() == track_from_) {
    energy_before_ = robot_.actuators()->audit();
  }
  if (adaptation_) {
    store(adaptation_->begin(tick()));
    if (const signals::SupplyState* supply = robot_.supply_state()) {
      adaptation_->take(*supply);
    }
  }
  if (knows_) {
    tell_wear();
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const robot::Joint& joint = joints_[i];
    trace::TraceRow truth;
    robot_.describe(i, truth);
    joint_node::JointNode::Inputs inputs;
    inputs.tick = tick();
    inputs.sensors = robot_.sample(i);
    inputs.command.joint = joint.number;
    inputs.command.tick = tick();
    inputs.command.position_rad = std::clamp(reading(i).position, joint.angle_min_rad, joint.angle_max_rad);
    inputs.command.torque_ff_Nm = torques_Nm[i];
    const joint_node::JointNode::Outputs outputs = nodes_[i].step(inputs);
    const signals::JointValveCommand& valve = outputs.valve;
    if (adaptation_) {
      adaptation_->take(outputs.measurement);
    }
    if (listener_) {
      listener_(outputs.measurement, truth);
    }
    if (joint.index_in_leg == 0) {
      late_[static_cast<std::size_t>(joint.leg)].step(truth.actual_phase, valve.phase);
    }
    std::vector<double>& ring = on_the_way_A_[i];
    const auto slots = static_cast<Tick>(ring.size());
    ring[static_cast<std::size_t>(tick() % slots)] = valve.valve_current_A;
    currents_A_[i] = ring[static_cast<std::size_t>((tick() + 1) % slots)];
    if (tick() >= track_from_) {
      track(i, truth, valve.force_reference_N_or_Nm);
    }
  }
  if (adaptation_) {
    adaptation_->end(tick());
  }
}

bool ActuatedRobot::move() noexcept {
  const bool moved = robot_.advance(currents_A_);
  if (const plant::Supply* supply = robot_.actuators()->supply()) {
    least_supply_Pa_ = std::min(least_supply_Pa_, supply->pressure_Pa());
  }
  return moved;
}

}  // namespace farrier::trials
