#include "supervisor/supervisor.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "control/model/model_rows.hpp"
#include "robot/joint_model.hpp"
#include "robot/sensor_path.hpp"
#include "supervisor/joint_design.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::supervisor {

namespace {

constexpr std::uint32_t kFirstAuthority = 1;
constexpr std::uint32_t kFirstEpoch = 1;

/// First gains act whatever they are, but their record says where they fall short of what is asked of new ones.
/// `outputs` ends with the joint's gains.
void record_shortfalls(const robot::Robot& robot, std::uint16_t joint, const SlotGains& first, int dwell,
                       Supervisor::Outputs& outputs) {
  const control::MeasurementFilters filters = robot::measurement_filters(robot.joints[joint], robot.period_s);
  const auto issued = std::span(outputs.gains).last(kPhases.size());
  for (const signals::Phase phase : kPhases) {
    const control::Gains& gains = first[static_cast<std::size_t>(phase)];
    const LoopMargins margins = margins_of(gains, robot.period_s, filters);
    const bool too_small = !sufficient(margins, robot.update_logic);
    if (!too_small && dwell <= shortest_phase_ticks(robot)) {
      continue;
    }
    signals::JointUpdateDecision decision;
    decision.joint = joint;
    decision.phase = phase;
    decision.verdict = too_small ? signals::UpdateVerdict::kMarginTooSmall : signals::UpdateVerdict::kDwellTooLong;
    decision.generation = issued[static_cast<std::size_t>(phase)].generation;
    decision.disk_margin = margins.disk;
    decision.delay_margin_s = margins.delay_s;
    decision.dwell_ticks = static_cast<std::uint32_t>(dwell);
    decision.model_a = control::rows_of(gains.model.a);
    decision.model_b = control::entries_of(gains.model.b);
    outputs.decisions.push_back(decision);
    outputs.design_statuses.push_back(control::DesignStatus::kSuccessful);
  }
}

}  // namespace

Result<Supervisor> Supervisor::create(const robot::Robot& robot, Design design, int loop_delay_ticks,
                                      std::uint64_t session, std::vector<robot::LoadChange> known_loads,
                                      const std::vector<SlotGains>& first_gains) {
  FARRIER_TRY(check_first(robot, first_gains, loop_delay_ticks));
  std::vector<std::uint32_t> generations(robot.joints.size(), 0);
  std::vector<Batch> batches(1);
  std::vector<JointSlots> slots;
  // A robot that stands on swing gains falls before an estimate can tell.
  const Design begins = robot.on_ground && design == Design::kAdaptive ? Design::kPhases : design;
  for (const robot::Joint& joint : robot.joints) {
    const auto first = FARRIER_TRY(first_gains.empty() ? design_slots(joint, begins, robot.period_s, loop_delay_ticks)
                                                       : Result<SlotGains>(first_gains[joint.number]));
    for (const signals::Phase phase : kPhases) {
      batches[0].outputs.gains.push_back(wire_gains::with_physics(
          wire_gains::pack_gains(joint.number, phase, kFirstAuthority, ++generations[joint.number],
                                 first[static_cast<std::size_t>(phase)]),
          first_physics(joint, design, phase)));
    }
    const bool changes_slots = robot.plan.gait.pattern != gait::Pattern::kStand;
    const int dwell = changes_slots ? dwell_ticks(first[0], first[1]) : 0;
    if (!control::takes_physics(joint.kind)) {  // there they do not act
      record_shortfalls(robot, joint.number, first, dwell, batches[0].outputs);
    }
    if (design == Design::kAdaptive) {
      const auto slot = [&](signals::Phase phase) {
        return SlotUpdate(joint, robot.update_logic, robot.period_s, robot.estimate_period_ticks,
                          first[static_cast<std::size_t>(phase)], loads_to_hold(robot, joint, phase), robot.on_ground);
      };
      // An estimate of the valve keeps the load, so it holds the phase's own; the file's valve is no longer there.
      const bool of_valve = joint.estimator.finds_valve();
      const auto physics = [&](signals::Phase phase) {
        return PhysicsUpdate(joint, robot.update_logic, robot.period_s, robot.estimate_period_ticks, loop_delay_ticks,
                             first_physics(joint, design, phase),
                             of_valve ? std::vector<plant::LoadParams>{} : loads_to_hold(robot, joint, phase),
                             robot.on_ground || of_valve);
      };
      slots.push_back({.slots = {slot(signals::Phase::kSwing), slot(signals::Phase::kStance)},
                       .physics = control::takes_physics(joint.kind)
                                      ? std::optional(PerPhase<PhysicsUpdate>{physics(signals::Phase::kSwing),
                                                                              physics(signals::Phase::kStance)})
                                      : std::nullopt,
                       .generations = {1, 2},
                       .first_physics = {first_physics(joint, design, signals::Phase::kSwing),
                                         first_physics(joint, design, signals::Phase::kStance)},
                       .newest_generation = 2,
                       .dwell_ticks = dwell});
    }
  }
  signals::SystemMode armed;
  armed.authority = kFirstAuthority;
  armed.epoch = kFirstEpoch;
  armed.session = session;
  armed.mode = signals::Mode::kArmed;
  batches[0].outputs.modes.push_back(armed);

  std::ranges::stable_sort(known_loads, {}, &robot::LoadChange::tick);
  for (const robot::LoadChange& known : known_loads) {
    if (known.joint >= robot.joints.size()) {
      return Error{"a known load of joint " + std::to_string(known.joint) + ", which " + robot.name + " does not have"};
    }
    const auto gains =
        FARRIER_TRY(design_joint(robot.joints[known.joint], known.load, robot.period_s, loop_delay_ticks));
    const Tick issue_tick = known.tick - robot.update_logic.gain_lead_ticks;
    if (batches.size() == 1 || batches.back().tick != issue_tick) {
      batches.push_back({issue_tick, {}});
    }
    for (const signals::Phase phase : kPhases) {
      batches.back().outputs.gains.push_back(wire_gains::with_physics(
          wire_gains::pack_gains(known.joint, phase, kFirstAuthority, ++generations[known.joint], gains),
          robot::nominal_physics(robot.joints[known.joint], known.load)));
    }
  }
  return Supervisor(std::move(batches), std::move(slots), robot.joints.size(), robot.update_logic.gain_lead_ticks,
                    shortest_phase_ticks(robot), session);
}

Supervisor::Supervisor(std::vector<Batch> batches, std::vector<JointSlots> joints, std::size_t joint_count,
                       int lead_ticks, int shortest_phase_ticks, std::uint64_t session)
    : batches_(std::move(batches)),
      joints_(std::move(joints)),
      lead_ticks_(lead_ticks),
      shortest_phase_ticks_(shortest_phase_ticks),
      session_(session),
      authority_(kFirstAuthority),
      epoch_(kFirstEpoch),
      known_gains_(joint_count * kPhases.size()) {
  for (Outputs* outputs : {&pending_, &issued_, &orders_}) {
    outputs->modes.reserve(1);
    outputs->gains.reserve(known_gains_.size());
    outputs->decisions.reserve(joints_.size());
    outputs->design_statuses.reserve(joints_.size());
  }
}

void Supervisor::take(const signals::SystemRequest& request) noexcept {
  if (request.session != session_) {
    return;
  }
  const bool arms = request.request == signals::Request::kArm;
  signals::SystemMode mode;
  mode.authority = authority_;
  mode.epoch = ++epoch_;
  mode.session = session_;
  mode.mode = arms ? signals::Mode::kArmed : signals::Mode::kStopped;
  pending_.modes.assign(1, mode);  // of several requests the last counts
}

void Supervisor::take(const signals::JointModelEstimate& estimate, Tick tick) noexcept {
  if (estimate.joint >= joints_.size() || !known(estimate.phase)) {
    return;
  }
  JointSlots& joint = joints_[estimate.joint];
  if (joint.looked) {
    return;
  }
  joint.looked = true;
  if (joint.physics) {
    take_physics(joint, estimate, tick);
  } else {
    take_gains(joint, estimate, tick);
  }
}

void Supervisor::take_gains(JointSlots& joint, const signals::JointModelEstimate& estimate, Tick tick) noexcept {
  SlotUpdate& slot = joint.slots[estimate.phase];
  const SlotPair pair{.other = joint.slots[other(estimate.phase)].gains(),
                      .shortest_phase_ticks = shortest_phase_ticks_,
                      .dwelling = tick - joint.last_issue < std::min(joint.dwell_ticks, shortest_phase_ticks_)};
  const signals::JointUpdateDecision decision = slot.look(estimate, tick, pair);
  if (decision.verdict == signals::UpdateVerdict::kAccepted) {
    joint.last_issue = tick;
    joint.dwell_ticks = static_cast<int>(decision.dwell_ticks);
    // With physics that no joint has, the joint would refuse the gains.
    const plant::JointPhysics estimated = plant::physics_of(estimate.physics);
    const bool physical = estimate.has_physics != 0 && plant::first_unphysical(estimated) == nullptr;
    issue(joint,
          wire_gains::with_physics(wire_gains::pack_gains(estimate.joint, estimate.phase, authority_, 0, slot.gains()),
                                   physical ? estimated : joint.first_physics[estimate.phase]));
  }
  if (slot.is_news()) {
    tell(joint, decision, slot.design_status());
  }
}

void Supervisor::take_physics(JointSlots& joint, const signals::JointModelEstimate& estimate, Tick tick) noexcept {
  PhysicsUpdate& slot = (*joint.physics)[estimate.phase];
  const signals::JointUpdateDecision decision = slot.look(estimate, tick);
  if (decision.verdict == signals::UpdateVerdict::kAccepted) {
    // The gains do not act; they go on as they were, with the model that came with the physics.
    control::Gains gains = joint.slots[estimate.phase].gains();
    gains.model = slot.model();
    issue(joint, wire_gains::with_physics(wire_gains::pack_gains(estimate.joint, estimate.phase, authority_, 0, gains),
                                          slot.physics()));
  }
  if (slot.is_news()) {
    tell(joint, decision, control::DesignStatus::kSuccessful);
  }
}

void Supervisor::issue(JointSlots& joint, signals::JointControllerGains gains) noexcept {
  gains.generation = joint.generations[gains.phase] = ++joint.newest_generation;
  pending_.gains.push_back(gains);
}

void Supervisor::tell(const JointSlots& joint, signals::JointUpdateDecision decision,
                      control::DesignStatus status) noexcept {
  decision.generation = joint.generations[decision.phase];
  pending_.decisions.push_back(decision);
  pending_.design_statuses.push_back(status);
}

std::uint64_t Supervisor::designs() const noexcept {
  std::uint64_t designs = 0;
  for (const JointSlots& joint : joints_) {
    for (const SlotUpdate& slot : joint.slots) {
      designs += slot.designs();
    }
  }
  return designs;
}

const Supervisor::Outputs& Supervisor::step(Tick tick) noexcept {
  const bool batch_due = next_batch_ < batches_.size() && (next_batch_ == 0 || batches_[next_batch_].tick <= tick);
  Outputs& due = batch_due ? batches_[next_batch_++].outputs : issued_;
  if (!batch_due) {
    for (JointSlots& joint : joints_) {
      joint.looked = false;
    }
    std::swap(issued_, pending_);
    pending_.clear();
  }
  for (signals::JointUpdateDecision& decision : due.decisions) {
    decision.tick = batch_due ? tick : decision.tick;
  }
  for (signals::JointControllerGains& gains : due.gains) {
    gains.effective_tick = tick + lead_ticks_;
  }
  for (signals::SystemMode& mode : due.modes) {
    mode.effective_tick = tick + lead_ticks_;
  }
  remember(due);
  return due;
}

}  // namespace farrier::supervisor
