#include "tools/monitor/metric_table.hpp"

#include <cmath>

#include "bus/bus.hpp"
#include "tools/monitor/metric_samples.hpp"

namespace farrier::display {
namespace {

using enum MetricKind;
using monitor::JointFrame;
using monitor::ParticipantFrame;
using State = MetricState;

constexpr double kGramsPerKilogram = 1e3;  // the gram is Prometheus's base unit of mass

double as_double(std::uint64_t count) { return static_cast<double>(count); }

/// One value of every joint that was heard of.
template <auto kValue>
void of_joints(const State& s, const Sample& sample) {
  each_heard_joint(s, [&](const robot::Joint& joint, const JointFrame& frame, const std::string& leg) {
    const double value = kValue(frame);
    if (!std::isnan(value)) {
      sample(value, {leg, joint.name});
    }
  });
}

template <bool kRotary>
void masses(const State& s, const Sample& sample) {
  each_heard_joint(s, [&](const robot::Joint& joint, const JointFrame& frame, const std::string& leg) {
    if (joint.rotary == kRotary && frame.mass_kg_or_kgm2) {
      sample(*frame.mass_kg_or_kgm2 * kGramsPerKilogram, {leg, joint.name});
    }
  });
}

// clang-format off
constexpr std::array kSpecs{
    // This monitor
    MetricSpec{"farrier_monitor_info", kGauge, {"robot"}, "Always 1: the robot that is watched.",
               [](const State& s, const Sample& sample) { sample(1.0, {s.robot.name}); }},
    MetricSpec{"farrier_monitor_frame_timestamp_seconds", kGauge, {}, "When this monitor last looked at the robot.",
               [](const State& s, const Sample& sample) { sample(s.frame_time_s, {}); }},
    MetricSpec{"farrier_monitor_start_timestamp_seconds", kGauge, {}, "When this monitor began to look at the robot.",
               [](const State& s, const Sample& sample) { sample(s.start_time_s, {}); }},
    MetricSpec{"farrier_monitor_last_sample_age_seconds", kGauge, {}, "Time since anything came from the robot; +Inf before the first.",
               [](const State& s, const Sample& sample) { sample(s.frame.age_s, {}); }},
    MetricSpec{"farrier_monitor_lost_samples_total", kCounter, {}, "Samples lost on the way to this monitor, as far as it can tell.",
               [](const State& s, const Sample& sample) { sample(as_double(s.frame.lost_samples), {}); }},

    // The run
    MetricSpec{"farrier_run_info", kGauge, {"robot", "session"}, "Always 1: the session of the run that is heard.",
               [](const State& s, const Sample& sample) {
                 for (const ParticipantFrame& process : s.frame.participants) {
                   if (process.hello.session != 0) {
                     return sample(1.0, {s.robot.name, std::to_string(process.hello.session)});
                   }
                 }
               }},
    MetricSpec{"farrier_run_ticks_total", kCounter, {}, "Control periods since the run began, as the newest sample has it.",
               [](const State& s, const Sample& sample) {
                 if (s.frame.tick != kNoTick) { sample(static_cast<double>(s.frame.tick), {}); }
               }},
    MetricSpec{"farrier_robot_mode", kGauge, {"mode"}, "1 for the mode the supervisor has set (idle, armed, stopped), 0 for the others.",
               [](const State& s, const Sample& sample) {
                 for (const auto mode : {signals::Mode::kIdle, signals::Mode::kArmed, signals::Mode::kStopped}) {
                   if (s.frame.mode.epoch != 0) {
                     sample(s.frame.mode.mode == mode ? 1.0 : 0.0, {signals::to_string(mode)});
                   }
                 }
               }},
    MetricSpec{"farrier_leg_phase_switches_total", kCounter, {"leg", "kind"}, "Changes of phase that the joints of a leg were told: planned ones, and touchdowns that were felt before their plan.",
               [](const State& s, const Sample& sample) {
                 for (std::size_t leg = 0; leg < s.frame.legs.size(); ++leg) {
                   const std::string& name = s.robot.plan.legs[leg].name;
                   sample(as_double(s.frame.legs[leg].planned_switches), {name, "planned"});
                   sample(as_double(s.frame.legs[leg].felt_switches), {name, "felt"});
                 }
               }},
    MetricSpec{"farrier_events_total", kCounter, {"severity"}, "Events of the robot's processes and of this monitor, those included from before it began, of which it is told.",
               [](const State& s, const Sample& sample) {
                 for (std::size_t i = 0; i < s.events.size(); ++i) {
                   sample(as_double(s.events[i]), {signals::to_string(static_cast<signals::Severity>(i))});
                 }
               }},

    // Joints
    MetricSpec{"farrier_joint_state", kGauge, {"leg", "joint", "state"}, "1 for what the joint does (null, damping, tracking), 0 for the others.",
               [](const State& s, const Sample& sample) {
                 each_heard_joint(s, [&](const robot::Joint& joint, const JointFrame& frame, const std::string& leg) {
                   for (const auto state : {signals::JointState::kNull, signals::JointState::kDamping, signals::JointState::kTracking}) {
                     sample(frame.newest.state == state ? 1.0 : 0.0, {leg, joint.name, signals::to_string(state)});
                   }
                 });
               }},
    MetricSpec{"farrier_joint_fault", kGauge, {"leg", "joint", "fault", "severity"}, "1 while the joint has the fault; its severity is that of the safety table.",
               [](const State& s, const Sample& sample) {
                 each_heard_joint(s, [&](const robot::Joint& joint, const JointFrame& frame, const std::string& leg) {
                   for (const FaultInfo& fault : kFaults) {
                     sample(FaultSet(frame.newest.faults).has(fault.fault) ? 1.0 : 0.0, {leg, joint.name, fault.name, to_string(fault.severity)});
                   }
                 });
               }},
    MetricSpec{"farrier_joint_fault_onsets_total", kCounter, {"leg", "joint", "fault", "severity"}, "Times the fault began, those between two scrapes included.",
               [](const State& s, const Sample& sample) {
                 each_joint(s, [&](const robot::Joint& joint, const JointFrame&, const std::string& leg) {
                   for (std::size_t i = 0; i < kFaults.size(); ++i) {
                     sample(as_double(s.fault_onsets[joint.number][i]), {leg, joint.name, kFaults[i].name, to_string(kFaults[i].severity)});
                   }
                 });
               }},
    MetricSpec{"farrier_joint_force_error_newtons", kGauge, {"leg", "joint"}, "RMS of force reference less force over the last second, of cylinders.",
               [](const State& s, const Sample& sample) { force_of_joints<false>(s, sample, [](const JointFrame& j) { return j.force_error_rms; }); }},
    MetricSpec{"farrier_joint_force_reference_newtons", kGauge, {"leg", "joint"}, "RMS of the force reference over the last second, of cylinders.",
               [](const State& s, const Sample& sample) { force_of_joints<false>(s, sample, [](const JointFrame& j) { return j.force_reference_rms; }); }},
    MetricSpec{"farrier_joint_torque_error_newton_meters", kGauge, {"leg", "joint"}, "RMS of torque reference less torque over the last second, of motors.",
               [](const State& s, const Sample& sample) { force_of_joints<true>(s, sample, [](const JointFrame& j) { return j.force_error_rms; }); }},
    MetricSpec{"farrier_joint_torque_reference_newton_meters", kGauge, {"leg", "joint"}, "RMS of the torque reference over the last second, of motors.",
               [](const State& s, const Sample& sample) { force_of_joints<true>(s, sample, [](const JointFrame& j) { return j.force_reference_rms; }); }},
    MetricSpec{"farrier_joint_tracking_error_ratio", kGauge, {"leg", "joint"}, "RMS error over RMS reference of force or torque over the last second; absent without a reference.",
               of_joints<[](const JointFrame& j) { return j.nrmse().value_or(NAN); }>},
    MetricSpec{"farrier_joint_load_mass_grams", kGauge, {"leg", "joint"}, "Mass of the load that the estimate has, of cylinders.", masses<false>},
    MetricSpec{"farrier_joint_load_inertia_gram_square_meters", kGauge, {"leg", "joint"}, "Inertia of the load that the estimate has, of motors.", masses<true>},
    MetricSpec{"farrier_joint_pole_modulus", kGauge, {"leg", "joint", "pole"}, "Modulus of a pole of the estimated joint in the z-plane, the largest first; absent without an estimate.",
               [](const State& s, const Sample& sample) {
                 each_heard_joint(s, [&](const robot::Joint& joint, const JointFrame& frame, const std::string& leg) {
                   for (std::size_t i = 0; i < frame.poles.size() && frame.estimate.tick != kNoTick; ++i) {
                     sample(std::abs(frame.poles[i]), {leg, joint.name, std::to_string(i + 1)});
                   }
                 });
               }},
    MetricSpec{"farrier_joint_estimate_validity_ratio", kGauge, {"leg", "joint"}, "How sure the estimator is of the joint's model, 0 to 1; absent without an estimate.",
               of_joints<[](const JointFrame& j) { return j.estimate.tick != kNoTick ? j.estimate.validity : NAN; }>},
    MetricSpec{"farrier_joint_gains_generation", kGauge, {"leg", "joint"}, "Generation of the gains that act.",
               of_joints<[](const JointFrame& j) { return static_cast<double>(j.newest.generation); }>},
    MetricSpec{"farrier_joint_redesigns_total", kCounter, {"leg", "joint"}, "Redesigned gains that the supervisor has issued.",
               of_joints<[](const JointFrame& j) { return static_cast<double>(j.redesigns); }>},
    MetricSpec{"farrier_joint_missed_ticks_total", kCounter, {"leg", "joint"}, "Control periods of the joint that are in no summary of it.",
               of_joints<[](const JointFrame& j) { return as_double(j.missed_ticks); }>},
    MetricSpec{"farrier_joint_control_rate_hertz", kGauge, {"leg", "joint"}, "Control periods per second of this monitor's clock over the last second.",
               of_joints<[](const JointFrame& j) { return j.rate_Hz; }>},
    MetricSpec{"farrier_joint_last_sample_age_seconds", kGauge, {"leg", "joint"}, "Time since the joint's last summary came, of which there are fifty a second.",
               of_joints<[](const JointFrame& j) { return j.age_s; }>},
    MetricSpec{"farrier_joint_valve_current_amperes", kGauge, {"leg", "joint"}, "Valve current of the last summary.",
               of_joints<[](const JointFrame& j) { return j.newest.valve_current_A; }>},

    // Processes
    MetricSpec{"farrier_process_info", kGauge, {"process", "dds"}, "Always 1: a process of the run, and the vendor it runs on.",
               [](const State& s, const Sample& sample) {
                 each_process(s, [&](const ParticipantFrame& process, const std::string& name) {
                   const bool known = process.hello.vendor <= static_cast<std::uint8_t>(bus::Vendor::kFast);
                   sample(1.0, {name, known ? bus::to_string(static_cast<bus::Vendor>(process.hello.vendor)) : "?"});
                 });
               }},
    MetricSpec{"farrier_process_health_age_seconds", kGauge, {"process"}, "Time since the process last reported its health; absent before the first report, which in lock-step comes at the end.",
               [](const State& s, const Sample& sample) {
                 each_healthy_process(s, [&](const ParticipantFrame& process, const std::string& name) { sample(process.age_s, {name}); });
               }},
    MetricSpec{"farrier_process_ended", kGauge, {"process"}, "1 after the process's last report.",
               [](const State& s, const Sample& sample) {
                 each_healthy_process(s, [&](const ParticipantFrame& process, const std::string& name) { sample(process.health.final_report != 0 ? 1.0 : 0.0, {name}); });
               }},
    MetricSpec{"farrier_process_periods_total", kCounter, {"process"}, "Periods of its control loop that were stepped.",
               [](const State& s, const Sample& sample) {
                 each_healthy_process(s, [&](const ParticipantFrame& process, const std::string& name) { sample(as_double(process.health.periods), {name}); });
               }},
    MetricSpec{"farrier_process_missed_periods_total", kCounter, {"process"}, "Periods of its control loop that passed without a step.",
               [](const State& s, const Sample& sample) {
                 each_healthy_process(s, [&](const ParticipantFrame& process, const std::string& name) { sample(as_double(process.health.missed_periods), {name}); });
               }},
    MetricSpec{"farrier_process_sent_samples_total", kCounter, {"process", "topic"}, "Samples that it published.",
               [](const State& s, const Sample& sample) { topic_counts(s, sample, &signals::SystemHealth::sent); }},
    MetricSpec{"farrier_process_received_samples_total", kCounter, {"process", "topic"}, "Samples that it received.",
               [](const State& s, const Sample& sample) { topic_counts(s, sample, &signals::SystemHealth::received); }},
    MetricSpec{"farrier_process_lost_samples_total", kCounter, {"process", "topic"}, "Samples that it knows it lost.",
               [](const State& s, const Sample& sample) { topic_counts(s, sample, &signals::SystemHealth::lost); }},
    MetricSpec{"farrier_process_wake_up_seconds", kGauge, {"process", "percentile"}, "Its control loop awake after its deadline, since the run began; percentile 100 is the largest.",
               [](const State& s, const Sample& sample) { percentiles(s, sample, &signals::SystemHealth::wake_up_s); }},
    MetricSpec{"farrier_valve_command_latency_seconds", kGauge, {"process", "percentile"}, "Sensor sample to valve command, since the run began; percentile 100 is the largest.",
               [](const State& s, const Sample& sample) { percentiles(s, sample, &signals::SystemHealth::latency_s); }},
};
// clang-format on

}  // namespace

std::span<const MetricSpec> metric_specs() noexcept { return kSpecs; }

std::string metrics_table_markdown() {
  std::string text = "| metric | type | labels | meaning |\n|---|---|---|---|\n";
  for (const MetricSpec& spec : kSpecs) {
    std::string labels;
    for (const char* label : spec.labels) {
      labels += label == nullptr ? "" : (labels.empty() ? "`" : ", `") + std::string(label) + "`";
    }
    text += "| `" + std::string(spec.name) + "` | " + (spec.kind == kCounter ? "counter" : "gauge") + " | " + labels +
            " | " + spec.help + " |\n";
  }
  return text;
}

}  // namespace farrier::display
