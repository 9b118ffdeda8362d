#include "supervisor/supervisor.hpp"

#include "supervisor/joint_design.hpp"

namespace farrier::supervisor {

signals::JointControllerGains pack_gains(std::uint16_t joint, signals::Phase phase, std::uint32_t epoch,
                                         std::uint32_t generation, const control::Gains& gains) noexcept {
  signals::JointControllerGains signal;
  signal.joint = joint;
  signal.phase = static_cast<std::uint8_t>(phase);
  signal.epoch = epoch;
  signal.generation = generation;
  signal.k_position = gains.position;
  signal.k_velocity = gains.velocity;
  signal.k_force = gains.force;
  signal.k_integral = gains.integral;
  signal.feed_forward = gains.feed_forward;
  signal.integral_factor = gains.integral_factor;
  signal.k_delay = gains.delay;
  signal.delay_ticks = static_cast<std::uint8_t>(gains.delay_ticks);
  signal.compliant = gains.form == control::Form::kCompliant ? 1 : 0;
  signal.position_scale_m_or_rad = gains.normalisation.position;
  signal.velocity_scale_m_s_or_rad_s = gains.normalisation.velocity;
  signal.force_scale_N_or_Nm = gains.normalisation.force;
  signal.current_scale_A = gains.normalisation.current_A;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      signal.model_a[static_cast<std::size_t>(3 * row + column)] = gains.model.a(row, column);
    }
    signal.model_b[static_cast<std::size_t>(row)] = gains.model.b(row);
  }
  return signal;
}

Design parse_design(std::string_view name) noexcept {
  if (name == "swing") {
    return Design::kSwing;
  }
  return name == "phases" ? Design::kPhases : Design::kStance;
}

Result<Supervisor> Supervisor::create(const robot::Robot& robot, Design design, int loop_delay_ticks,
                                      std::uint64_t session) {
  constexpr std::uint32_t kFirstEpoch = 1;
  Outputs first;
  for (const robot::Joint& joint : robot.joints) {
    std::uint32_t generation = 0;
    for (const signals::Phase phase : {signals::Phase::kSwing, signals::Phase::kStance}) {
      const bool for_stance = design == Design::kStance || (design == Design::kPhases && phase == signals::Phase::kStance);
      const auto gains = design_joint(joint, for_stance ? joint.stance_load : joint.swing_load, robot.period_s,
                                      loop_delay_ticks);
      if (!gains) {
        return gains.error();
      }
      first.gains.push_back(pack_gains(joint.number, phase, kFirstEpoch, ++generation, gains.value()));
    }
  }
  signals::SystemMode armed;
  armed.epoch = kFirstEpoch;
  armed.session = session;
  armed.mode = static_cast<std::uint8_t>(signals::Mode::kArmed);
  first.modes.push_back(armed);
  return Supervisor(std::move(first));
}

const Supervisor::Outputs& Supervisor::step(Tick tick) noexcept {
  if (issued_) {
    return nothing_;
  }
  issued_ = true;
  for (signals::JointControllerGains& gains : first_.gains) {
    gains.effective_tick = tick + kLeadTicks;
  }
  for (signals::SystemMode& mode : first_.modes) {
    mode.effective_tick = tick + kLeadTicks;
  }
  return first_;
}

void Supervisor::take(const signals::JointModelEstimate&) noexcept { ++estimates_; }

}  // namespace farrier::supervisor
