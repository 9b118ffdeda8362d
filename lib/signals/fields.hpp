#pragma once

// The field list of every signal, once. Codecs, the contract's hash, the tables in idl/README.md and the round-trip
// tests are all expanded from here; a name that idl/ spells differently does not compile.

#include "signals/signals.hpp"

// clang-format off
/// X(SignalType, idl_file_stem), in the order of bus::TopicId.
#define FARRIER_SIGNALS(X)                            \
  X(JointSensors, joint_sensors)                      \
  X(JointCommand, joint_command)                      \
  X(JointValveCommand, joint_valve_command)           \
  X(JointMeasurement, joint_measurement)              \
  X(JointModelEstimate, joint_model_estimate)         \
  X(JointControllerGains, joint_controller_gains)     \
  X(JointUpdateDecision, joint_update_decision)       \
  X(GaitPhase, gait_phase)                            \
  X(SystemHello, system_hello)                        \
  X(SystemHealth, system_health)                      \
  X(SystemEvent, system_event)                        \
  X(SystemMode, system_mode)                          \
  X(SystemRequest, system_request)                    \
  X(ClockTick, clock_tick)                            \
  X(ClockTickDone, clock_tick_done)                   \
  X(JointSummary, joint_summary)                      \
  X(JointModelEstimateCopy, joint_model_estimate_copy) \
  X(SystemJournal, system_journal)

#define FARRIER_FIELDS_JointSensors(F) \
  F(joint) F(tick) F(sample_time_ns) F(position_m_or_rad) F(velocity_m_s_or_rad_s) F(force_N_or_Nm) \
  F(required_generation) F(required_epoch)

#define FARRIER_FIELDS_JointCommand(F) \
  F(joint) F(tick) F(sample_time_ns) F(position_rad) F(velocity_rad_s) F(torque_ff_Nm) F(stiffness_Nm_rad) \
  F(damping_Nms_rad) F(announced_phases)

#define FARRIER_FIELDS_JointValveCommand(F) \
  F(joint) F(tick) F(sample_time_ns) F(valve_current_A) F(force_reference_N_or_Nm) F(generation) F(faults) \
  F(state) F(phase)

#define FARRIER_FIELDS_JointMeasurement(F) \
  F(joint) F(tick) F(sample_time_ns) F(position_m_or_rad) F(velocity_m_s_or_rad_s) F(force_N_or_Nm) \
  F(valve_current_A) F(force_reference_N_or_Nm) F(generation) F(faults) F(state) F(phase)

#define FARRIER_FIELDS_JointModelEstimate(F) \
  F(joint) F(tick) F(phase) F(a) F(b) F(c) F(a_error) F(b_error) F(validity) F(excitation) \
  F(prediction_error) F(whiteness) F(samples) F(flags) \
  F(has_physics) F(physics) F(physics_error)

#define FARRIER_FIELDS_JointControllerGains(F) \
  F(joint) F(phase) F(authority) F(generation) F(effective_tick) F(k_position) F(k_velocity) F(k_force) F(k_integral) \
  F(feed_forward) F(integral_factor) F(k_delay) F(delay_ticks) F(compliant) F(position_scale_m_or_rad) \
  F(velocity_scale_m_s_or_rad_s) F(force_scale_N_or_Nm) F(current_scale_A) F(model_a) F(model_b) \
  F(has_physics) F(physics)

#define FARRIER_FIELDS_JointUpdateDecision(F) \
  F(joint) F(tick) F(phase) F(verdict) F(generation) F(estimate_samples) F(validity) F(excitation) \
  F(prediction_error) F(whiteness) F(pole_distance) F(pole_spread) F(converged_ticks) F(poles_re) F(poles_im) \
  F(designed_poles_re) F(designed_poles_im) F(estimated_radius) F(stored_radius) F(disk_margin) F(delay_margin_s) \
  F(dwell_ticks) F(model_a) F(model_b)

#define FARRIER_FIELDS_GaitPhase(F) \
  F(leg) F(count) F(announced_tick) F(switch_tick) F(phase)

#define FARRIER_FIELDS_SystemHello(F) \
  F(participant) F(session) F(contract) F(pid) F(vendor) F(routes_expected) F(routes_heard) \
  F(authority) F(mode_epoch) F(name)

#define FARRIER_FIELDS_SystemHealth(F) \
  F(participant) F(tick) F(final_report) F(periods) F(missed_periods) F(latency_s) F(wake_up_s) F(sent) F(received) \
  F(lost)

#define FARRIER_FIELDS_SystemEvent(F) \
  F(participant) F(count) F(tick) F(severity) F(joint) F(text)

#define FARRIER_FIELDS_SystemMode(F) \
  F(robot) F(authority) F(epoch) F(session) F(effective_tick) F(mode)

#define FARRIER_FIELDS_SystemRequest(F) \
  F(robot) F(session) F(tick) F(count) F(request)

#define FARRIER_FIELDS_ClockTick(F) \
  F(clock) F(tick)

#define FARRIER_FIELDS_ClockTickDone(F) \
  F(participant) F(tick) F(issued_gains) F(issued_modes)

#define FARRIER_FIELDS_JointSummary(F) \
  F(joint) F(tick) F(sample_time_ns) F(ticks) F(position_m_or_rad) F(velocity_m_s_or_rad_s) F(force_N_or_Nm) \
  F(force_reference_N_or_Nm) F(valve_current_A) F(force_error_rms_N_or_Nm) F(force_reference_rms_N_or_Nm) \
  F(generation) F(faults) F(state) F(phase)

#define FARRIER_FIELDS_JointModelEstimateCopy(F) FARRIER_FIELDS_JointModelEstimate(F)

#define FARRIER_FIELDS_SystemJournal(F) \
  F(stream) F(contract) F(samples_before) F(tick) F(closed_after_ns) F(samples) F(bytes)
// clang-format on

namespace farrier::signals {

/// Calls visitor(name, field) for every field of a signal, in wire order.
#define FARRIER_VISIT_FIELD(field) visitor(#field, signal.field);
#define FARRIER_VISIT(Signal, file)                      \
  template <class Visitor>                               \
  constexpr void visit_fields(Signal& signal, Visitor&& visitor) { \
    FARRIER_FIELDS_##Signal(FARRIER_VISIT_FIELD)         \
  }                                                      \
  template <class Visitor>                               \
  constexpr void visit_fields(const Signal& signal, Visitor&& visitor) { \
    FARRIER_FIELDS_##Signal(FARRIER_VISIT_FIELD)         \
  }
FARRIER_SIGNALS(FARRIER_VISIT)
#undef FARRIER_VISIT
#undef FARRIER_VISIT_FIELD

}  // namespace farrier::signals
