#include "tests/support/made_up_robot.hpp"

#include <cmath>
#include <numbers>

#include "control/model/discretise.hpp"
#include "control/model/model_rows.hpp"
#include "core/ensure.hpp"
#include "core/fault.hpp"
#include "signals/cdr.hpp"
#include "report/figures/recording_facts.hpp"

namespace farrier::test {
namespace {

constexpr Tick kStride = 900;
constexpr std::uint64_t kMadeUpStep_ns = 20'000'000;
constexpr double kForward_m_s = 0.3;
constexpr double kTrunkHeight_m = 0.58;
constexpr double kPumpFlow_m3_s = 2e-4;  // 12 l/min
constexpr double kDrift_m = 0.02;        // of locomotion's estimate
constexpr const char* kProcesses[] = {"sim_bridge", "supervisor", "estimator_service", "joint_node_lf"};

}  // namespace

template <class Signal>
void MadeUpRobot::say(const Signal& signal) {
  signals::to_cdr(signal, cdr_);
  take_({.topic = bus::TopicOf<Signal>::id,
         .sequence = 0,
         .log_time_ns = time_ns_,
         .publish_time_ns = time_ns_,
         .cdr = cdr_});
}

void MadeUpRobot::say_event(std::uint16_t participant, signals::Severity severity, std::uint16_t joint,
                            const std::string& text) {
  signals::SystemEvent event;
  event.participant = participant;
  event.count = ++events_;
  event.tick = tick_;
  event.severity = severity;
  event.joint = joint;
  signals::assign(event.text, text);
  say(event);
}

signals::Phase MadeUpRobot::phase_of(int leg, Tick tick) const {
  const auto offset = static_cast<Tick>(robot_.plan.legs[static_cast<std::size_t>(leg)].phase_offset * kStride);
  return (tick + offset) % kStride < kStride / 2 ? signals::Phase::kStance : signals::Phase::kSwing;
}

void MadeUpRobot::begin(std::uint64_t session, std::uint64_t time_ns) {
  time_ns_ = time_ns;
  tick_ = 0;
  std::uint16_t number = 0;
  for (const char* name : kProcesses) {
    signals::SystemHello hello;
    hello.participant = number++;
    hello.session = session;
    signals::assign(hello.name, name);
    say(hello);
  }
  signals::SystemMode mode;
  mode.epoch = 1;
  mode.session = session;
  mode.effective_tick = 0;
  mode.mode = signals::Mode::kArmed;
  say(mode);
  say_event(1, signals::Severity::kInfo, signals::kNoJoint, "armed");
  for (const robot::Joint& joint : robot_.joints) {
    say_gains(joint.number, Phase::kSwing);
    say_gains(joint.number, Phase::kStance);
  }
}

void MadeUpRobot::step(std::uint64_t time_ns) {
  time_ns_ = time_ns;
  tick_ += kTicksPerStep;
  for (std::size_t leg = 0; leg < robot_.plan.legs.size(); ++leg) {
    const auto number = static_cast<int>(leg);
    const signals::Phase now = phase_of(number, tick_);
    if (now != phase_of(number, tick_ - kTicksPerStep)) {
      signals::GaitPhase phase;
      phase.leg = static_cast<std::uint16_t>(leg);
      phase.count = ++announcements_;
      phase.announced_tick = phase.switch_tick = tick_;
      phase.phase = now;
      say(phase);
    }
  }
  say_summaries();
  say_body();
  say_supply(tick_ - kTicksPerStep / 2);
  say_supply(tick_);
  if (tick_ % 100 == 0) {
    say_estimates();
    for (std::size_t number = 0; number < std::size(kProcesses); ++number) {
      signals::SystemHealth health;
      health.participant = static_cast<std::uint16_t>(number);
      health.tick = tick_;
      health.periods = static_cast<std::uint64_t>(tick_);
      say(health);
    }
  }
  if (tick_ % 1500 == 0) {
    const auto joint = static_cast<std::uint16_t>(tick_ / 1500 % robot_.joints.size());
    ++generation_;
    say_gains(joint, Phase::kStance);
    say_event(1, signals::Severity::kInfo, joint, "new gains in stance");
  }
}

void MadeUpRobot::say_summaries() {
  for (const robot::Joint& joint : robot_.joints) {
    const signals::Phase phase = phase_of(joint.leg, tick_);
    const double size = joint.rotary ? 60.0 : 1500.0;
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(tick_) / kStride + 0.7 * joint.number;
    const double load = phase == signals::Phase::kStance ? 0.9 : 0.15;
    const bool lost = FaultSet(faults_[joint.number]).has(Fault::kForceLost);
    signals::JointSummary s;
    s.joint = joint.number;
    s.tick = tick_;
    s.ticks = kTicksPerStep;
    s.position_m_or_rad = joint.linkage.position(joint.home_angle_rad);
    s.force_reference_N_or_Nm = size * (load + 0.3 * std::sin(2.0 * angle));
    const double lag = size * (0.05 * std::cos(2.0 * angle) + 0.015 * std::sin(23.0 * angle));
    s.force_N_or_Nm = lost ? 0.0 : s.force_reference_N_or_Nm - lag;
    s.valve_current_A = 0.002 * std::cos(2.0 * angle);
    s.force_error_rms_N_or_Nm = std::abs(s.force_reference_N_or_Nm - s.force_N_or_Nm);
    s.force_reference_rms_N_or_Nm = std::abs(s.force_reference_N_or_Nm);
    s.generation = generation_;
    s.faults = faults_[joint.number];
    s.state = lost ? signals::JointState::kDamping : signals::JointState::kTracking;
    s.phase = phase;
    say(s);
  }
}

void MadeUpRobot::say_body() {
  const double weight_N = robot_.body ? body::total_mass_kg(*robot_.body) * robot_.body->gravity_m_s2 : 0.0;
  if (weight_N == 0.0 || !says_body_) {
    return;
  }
  signals::BodyTruth truth;
  truth.tick = tick_;
  truth.velocity_m_s = {kForward_m_s, 0.0, 0.0};
  truth.position_m = {kForward_m_s * static_cast<double>(tick_) * robot_.period_s, 0.0, kTrunkHeight_m};
  truth.attitude = {1.0, 0.0, 0.0, 0.0};
  signals::BodyState state;
  state.tick = tick_;
  state.mode = MotionMode::kTrot;
  state.position_m = truth.position_m;
  state.position_m[1] = kDrift_m;
  state.attitude = truth.attitude;
  state.velocity_m_s = truth.velocity_m_s;
  state.command = {kForward_m_s, 0.0, 0.0, 0.0};
  for (std::size_t leg = 0; leg < robot_.plan.legs.size(); ++leg) {
    const bool stands = phase_of(static_cast<int>(leg), tick_) == Phase::kStance;
    state.stands[leg] = stands ? 1 : 0;
    truth.foot_force_N[3 * leg + 2] = stands ? weight_N / 2.0 : 0.0;
    state.felt_force_N[3 * leg + 2] = 0.95 * truth.foot_force_N[3 * leg + 2];
  }
  say(truth);
  say(state);
}

void MadeUpRobot::say_supply(Tick tick) {
  if (!robot_.supply || !says_body_) {
    return;
  }
  const double seconds = static_cast<double>(tick) * robot_.period_s;
  const double swing = std::sin(2.0 * std::numbers::pi * static_cast<double>(tick) / kStride);
  signals::SupplyState state;
  state.tick = tick;
  state.pressure_Pa = 150e5 + 4e5 * swing;
  state.pump_flow_m3_s = kPumpFlow_m3_s;
  state.flow_m3_s = kPumpFlow_m3_s * (0.6 + 0.3 * swing);
  state.relief_flow_m3_s = 0.25 * kPumpFlow_m3_s;
  state.leakage_flow_m3_s = 0.15 * kPumpFlow_m3_s;
  state.power_W = state.pressure_Pa * kPumpFlow_m3_s;
  say(state);
  signals::SupplyTruth truth;
  truth.tick = tick;
  for (const robot::Joint& joint : robot_.joints) {
    truth.pressure_a_Pa[joint.number] = 80e5 + 40e5 * swing;
    truth.pressure_b_Pa[joint.number] = 60e5 - 30e5 * swing;
  }
  truth.pump_J = 3000.0 * seconds;
  truth.relief_J = 750.0 * seconds;
  truth.supply_leakage_J = 600.0 * seconds;
  truth.accumulator_J = -60.0 * seconds;
  truth.valve_J = 1500.0 * seconds;
  truth.leakage_J = 90.0 * seconds;
  truth.friction_J = 90.0 * seconds;
  truth.work_J = 30.0 * seconds;
  say(truth);
}

void MadeUpRobot::say_gains(std::uint16_t joint, Phase phase) {
  signals::JointControllerGains gains;
  gains.joint = joint;
  gains.phase = phase;
  gains.authority = 1;
  gains.generation = generation_;
  gains.effective_tick = tick_;
  const double change = 1.0 + 0.1 * std::sin(generation_);
  gains.k_position = 0.02 * change;
  gains.k_velocity = (phase == Phase::kSwing ? 0.3 : 0.8) * change;
  gains.k_force = (phase == Phase::kSwing ? 0.6 : 1.4) / change;
  gains.k_integral = (phase == Phase::kSwing ? 0.1 : 0.25) * change;
  gains.feed_forward = 1.0;
  say(gains);
}

void MadeUpRobot::say_estimates() {
  for (const robot::Joint& joint : robot_.joints) {
    const double drift = std::sin(static_cast<double>(tick_) / 4000.0 + joint.number);
    const double mass = joint.rotary ? 1.2 + 0.2 * drift : 45.0 + 12.0 * drift;
    Eigen::Matrix3d a;  // position, velocity and force of a load on a compressible line
    a << 0.0, 1.0, 0.0, 0.0, -60.0 / mass, 1.0 / mass, 0.0, -4e5 * (1.0 + 0.2 * drift), -90.0;
    const control::DiscreteModel model = control::discretise(a, {0.0, 0.0, 2e7}, robot_.period_s);
    signals::JointModelEstimateCopy estimate;
    estimate.joint = joint.number;
    estimate.tick = tick_;
    estimate.phase = phase_of(joint.leg, tick_);
    estimate.a = control::rows_of(model.a);
    estimate.b = control::entries_of(model.b);
    estimate.validity = 0.85 + 0.1 * drift;
    estimate.excitation = 1e-3 * (1.5 + drift);
    estimate.prediction_error = 1.2 + 0.2 * drift;
    estimate.samples = static_cast<std::uint32_t>(tick_);
    say(estimate);
  }
}

void MadeUpRobot::set_faults(std::uint16_t joint, std::uint32_t bits, std::uint64_t time_ns) {
  time_ns_ = time_ns;
  faults_.at(joint) = bits;
  say_event(3, bits == 0 ? signals::Severity::kInfo : signals::Severity::kError, joint,
            bits == 0 ? "no faults" : to_string(FaultSet(bits)));
}

void write_made_up_recording(const std::string& path, const robot::Robot& robot, int seconds) {
  auto file = recording::RunFileWriter::create(path, report::recording_facts(robot));
  FARRIER_ENSURE(file.ok(), "a recording that can be written");
  std::uint64_t time_ns = 1'700'000'000'000'000'000;
  MadeUpRobot made_up(robot, [&](const recording::Sample& sample) { file.value().write(sample); });
  made_up.begin(7, time_ns);
  const robot::Joint* knee = robot.find("lf_kfe");
  const Tick last = static_cast<Tick>(seconds) * 1000, begin = last / 2, end = begin + 2000;
  while (made_up.tick() < last) {
    time_ns += kMadeUpStep_ns;
    if (knee != nullptr && (made_up.tick() == begin || made_up.tick() == end)) {
      made_up.set_faults(knee->number, made_up.tick() == begin ? static_cast<std::uint32_t>(Fault::kForceLost) : 0,
                         time_ns);
    }
    made_up.step(time_ns);
  }
  FARRIER_ENSURE(file.value().finish({}).ok(), "a disk that takes a recording");
}

}  // namespace farrier::test
