#include "wire_gains/wire_gains.hpp"

#include "control/model/model_rows.hpp"

namespace farrier::wire_gains {

signals::JointControllerGains pack_gains(std::uint16_t joint, signals::Phase phase, std::uint32_t authority,
                                         std::uint32_t generation, const control::Gains& gains) noexcept {
  signals::JointControllerGains signal;
  signal.joint = joint;
  signal.phase = phase;
  signal.authority = authority;
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
  signal.model_a = control::rows_of(gains.model.a);
  signal.model_b = control::entries_of(gains.model.b);
  return signal;
}

signals::JointControllerGains with_physics(signals::JointControllerGains gains,
                                           const plant::JointPhysics& physics) noexcept {
  gains.has_physics = plant::first_unphysical(physics) == nullptr ? 1 : 0;
  gains.physics = plant::values_of(physics);
  return gains;
}

control::Gains unpack_gains(const signals::JointControllerGains& signal) noexcept {
  control::Gains gains{};
  gains.normalisation = {signal.position_scale_m_or_rad, signal.velocity_scale_m_s_or_rad_s, signal.force_scale_N_or_Nm,
                         signal.current_scale_A};
  gains.position = signal.k_position;
  gains.velocity = signal.k_velocity;
  gains.force = signal.k_force;
  gains.integral = signal.k_integral;
  gains.feed_forward = signal.feed_forward;
  gains.integral_factor = signal.integral_factor;
  gains.delay = signal.k_delay;
  gains.delay_ticks = signal.delay_ticks;
  gains.form = signal.compliant != 0 ? control::Form::kCompliant : control::Form::kFullState;
  gains.model = control::model_of_rows(signal.model_a, signal.model_b);
  return gains;
}

}  // namespace farrier::wire_gains
