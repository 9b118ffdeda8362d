#include "joint_node/joint_node.hpp"

#include <algorithm>
#include <cmath>

#include "robot/sensor_path.hpp"

namespace farrier::joint_node {
namespace {

using signals::JointState;
using signals::Phase;

constexpr double kPercent = 0.01;
constexpr double kUniform = 0.28867513459481287;  // standard deviation of a uniform distribution of width 1 (1/√12)
constexpr std::uint64_t kDitherSeed = 0;  // the joint's own: the dither does not depend on the world's random numbers

}  // namespace

JointNode::JointNode(const robot::Joint& joint, const robot::Safety& safety, double period_s, int loop_delay_ticks,
                     std::uint64_t session)
    : joint_(joint),
      safety_(safety),
      session_(session),
      stance_lead_ticks_(std::llround(safety.stance_lead_s / period_s)),
      home_position_(joint.linkage.position(joint.home_angle_rad)),
      dither_amplitude_A_(kPercent * joint.dither_percent * joint.actuator.valve_current_max_A),
      dither_sign_(kDitherSeed, joint.name, "dither"),
      compensation_(
          joint.effects, joint.actuator,
          {period_s, std::hypot(joint.noise.position, kUniform * joint.sensors.position_step), joint.noise.velocity}),
      equaliser_(robot::filter_equaliser(joint, period_s)),
      predictor_(compensation_.delay_s(), period_s, loop_delay_ticks),
      pid_(joint.pid, joint.normalisation, period_s),
      sensor_check_(joint, safety),
      fault_assessor_(safety) {
  if (joint.kind == control::Kind::kFeedbackLinearisation) {
    flow_law_.emplace(joint.actuator, joint.feedback_linearisation, home_position_, period_s);
  }
  if (joint.kind == control::Kind::kFlowInversion) {
    flow_inversion_.emplace(joint.actuator, joint.flow_inversion, home_position_,
                            joint.stance_load.equilibrium_position, period_s,
                            loop_delay_ticks + static_cast<int>(std::lround(compensation_.delay_s() / period_s)));
  }
  faults_.set(Fault::kDisarmed);
  faults_.set(Fault::kNoGains);
}

bool JointNode::store_gains(const signals::JointControllerGains& signal, const control::Gains& gains) noexcept {
  auto& upcoming = upcoming_gains_[signal.phase];
  if (issue_of(signal) <= upcoming.newest() || signal.authority < newest_authority_) {
    return false;
  }
  newest_authority_ = signal.authority;
  upcoming.put({gains, plant::physics_of(signal.physics), issue_of(signal), signal.effective_tick});
  return true;
}

void JointNode::refuse_gains(const signals::JointControllerGains& signal) noexcept {
  const Phase phase = known(signal.phase) ? signal.phase : Phase::kSwing;
  upcoming_refusals_[phase].put({issue_of(signal), signal.effective_tick});
}

void JointNode::set_mode(const signals::SystemMode& mode) noexcept {
  if (mode.session == session_) {
    upcoming_modes_.put(mode);
  }
}

void JointNode::announce_phase(const signals::GaitPhase& phase) noexcept {
  if (!known(phase.phase)) {
    return;
  }
  signals::GaitPhase acting = phase;
  if (phase.phase == Phase::kStance) {
    // Swing gains are unstable on the stance load, stance gains stable on the swing load: a leg may land early, so be
    // early (docs/decisions/0016). Ticks before 0 are as due as 0.
    acting.switch_tick = std::max<Tick>(phase.switch_tick, 0) - stance_lead_ticks_;
  }
  if (phase.felt != 0) {
    // It is due at once, and a joint may not have made the tick before that of the announcement yet.
    acting.switch_tick = std::max(acting.switch_tick, phase.announced_tick);
  }
  upcoming_phases_.put(acting);
}

bool JointNode::same(const Slot& one, const Slot& other) noexcept {
  const control::Gains& a = one.gains;
  const control::Gains& b = other.gains;
  return generation_of(one.issue) == generation_of(other.issue) && a.position == b.position &&
         a.velocity == b.velocity && a.force == b.force && a.integral == b.integral &&
         a.feed_forward == b.feed_forward && a.integral_factor == b.integral_factor && a.delay == b.delay &&
         a.delay_ticks == b.delay_ticks && a.form == b.form &&
         plant::values_of(one.physics) == plant::values_of(other.physics);
}

std::uint32_t JointNode::newest_generation() const noexcept {
  Issue newest = 0;
  for (std::size_t phase = 0; phase < acting_.size(); ++phase) {
    newest = std::max({newest, upcoming_gains_[phase].newest(), upcoming_refusals_[phase].newest()});
  }
  return generation_of(newest);
}

void JointNode::apply_due(Tick tick) noexcept {
  if (const auto mode = upcoming_modes_.take_due(tick)) {
    mode_ = *mode;
  }
  for (std::size_t phase = 0; phase < acting_.size(); ++phase) {
    if (const auto slot = upcoming_gains_[phase].take_due(tick)) {
      // The next supervisor repeats the same gains: the controller continues in its state.
      if (controller_issue_ == acting_[phase].issue && same(*slot, acting_[phase])) {
        controller_issue_ = slot->issue;
      }
      acting_[phase] = *slot;
    }
    if (const auto refusal = upcoming_refusals_[phase].take_due(tick)) {
      refused_[phase] = *refusal;
    }
  }
  if (const auto phase = upcoming_phases_.take_due(tick)) {
    phase_ = phase->phase;
    phase_count_ = phase->count;
  }
}

void JointNode::assess(const Inputs& inputs) noexcept {
  bool last_was_refused = false;
  for (std::size_t phase = 0; phase < acting_.size(); ++phase) {
    last_was_refused = last_was_refused || refused_[phase].issue > acting_[phase].issue;
  }
  fault_assessor_.assess({.joint = joint_,
                          .limits = safety_,
                          .mode = mode_,
                          .sensors = inputs.sensors,
                          .command = inputs.command,
                          .command_age_s = inputs.command_age_s,
                          .since_last_step_s = inputs.since_last_step_s,
                          .readings = sensor_check_.take(inputs.sensors, inputs.sensors_age_s),
                          .has_gains = acting_[static_cast<std::size_t>(phase_)].issue != 0,
                          .gains_refused = last_was_refused},
                         faults_);
}

control::ForceReference JointNode::force_reference(const control::Measurement& measured,
                                                   const signals::JointCommand& command, JointState state) noexcept {
  const double q = joint_.linkage.angle(measured.position);
  const double q_dot = joint_.linkage.angular_velocity(q, measured.velocity);
  double torque = 0;
  double stiffness = 0;
  double damping = safety_.damping_gain_Nms_rad;
  bool clamped = false;
  if (state == JointState::kTracking) {
    const double q_ref = std::clamp(command.position_rad, joint_.angle_min_rad, joint_.angle_max_rad);
    clamped = q_ref != command.position_rad;
    // tau_ref = tau_ff + k_p (q_ref - q) + k_d (q̇_ref - q̇)   (Hubacher 2014, Fig. 1.3)
    stiffness = command.stiffness_Nm_rad;
    damping = command.damping_Nms_rad;
    torque = command.torque_ff_Nm + command.stiffness_Nm_rad * (q_ref - q) +
             command.damping_Nms_rad * (command.velocity_rad_s - q_dot);
  } else {
    torque = -safety_.damping_gain_Nms_rad * q_dot;
  }
  const double wanted = joint_.linkage.force(q, torque);
  // Numbers too large to add up (inf - inf) ask for nothing.
  const double reference = std::isnan(wanted) ? 0.0 : std::clamp(wanted, -joint_.pull_limit, joint_.push_limit);
  faults_.set(Fault::kReferenceClamped, clamped || reference != wanted);
  // F = tau / r, dx = r dq with the lever r, whose own change under a force is left out. At its limit it does not move.
  const double lever = joint_.linkage.lever(q);
  const double moves = reference == wanted ? 1.0 / (lever * lever) : 0.0;
  return {reference, stiffness * moves, damping * moves};
}

double JointNode::dither_A(Tick tick) const noexcept {
  if (!(dither_amplitude_A_ > 0.0)) {
    return 0.0;
  }
  constexpr double kEvenOdds = 0.5;
  const bool positive = dither_sign_.uniform(tick / std::max(1, joint_.dither_hold_ticks)) < kEvenOdds;
  return positive ? dither_amplitude_A_ : -dither_amplitude_A_;
}

JointNode::Outputs JointNode::step(const Inputs& inputs) noexcept {
  apply_due(inputs.tick);
  assess(inputs);
  const SafeOutput output = faults_.output();
  const JointState now = state_of(output);

  control::ForceReference reference = 0.0;
  double current_A = 0;
  const bool without_force = output == SafeOutput::kPositionDamping;
  if (!without_force) {
    held_position_ = inputs.sensors.position_m_or_rad;
  }
  if (now == JointState::kNull || without_force) {
    reset_controller();
    current_A = without_force ? holding_current(inputs.sensors.position_m_or_rad) : 0.0;
  } else {
    control::Measurement measured = compensation_.corrected(
        {inputs.sensors.position_m_or_rad, inputs.sensors.velocity_m_s_or_rad_s, inputs.sensors.force_N_or_Nm});
    reference = force_reference(measured, inputs.command, now);
    measured = equaliser_.take(measured);
    // Designs are linearised at the home pose; the controller sees the deviation from there.
    measured.position -= home_position_;
    const double probe_A = now == JointState::kTracking ? dither_A(inputs.tick) : 0.0;
    current_A = compensation_.current_A(valve_current(reference, measured, probe_A), measured);
  }

  Outputs out;
  signals::JointValveCommand& valve = out.valve;
  valve.joint = joint_.number;
  valve.tick = inputs.sensors.tick;
  valve.sample_time_ns = inputs.sensors.sample_time_ns;
  valve.valve_current_A = current_A;
  valve.force_reference_N_or_Nm = reference.force;
  valve.generation = generation_of(controller_issue_);
  valve.faults = faults_.bits();
  valve.state = now;
  valve.phase = phase_;

  signals::JointMeasurement& measurement = out.measurement;
  measurement.joint = joint_.number;
  measurement.tick = inputs.sensors.tick;
  measurement.sample_time_ns = inputs.sensors.sample_time_ns;
  measurement.position_m_or_rad = inputs.sensors.position_m_or_rad;
  measurement.velocity_m_s_or_rad_s = inputs.sensors.velocity_m_s_or_rad_s;
  measurement.force_N_or_Nm = inputs.sensors.force_N_or_Nm;
  measurement.valve_current_A = current_A;
  measurement.force_reference_N_or_Nm = reference.force;
  measurement.generation = valve.generation;
  measurement.faults = valve.faults;
  measurement.command_tick = inputs.command.tick;
  measurement.mode_epoch = mode_.epoch;
  measurement.phase_count = phase_count_;
  measurement.state = valve.state;
  measurement.phase = valve.phase;
  return out;
}

}  // namespace farrier::joint_node
