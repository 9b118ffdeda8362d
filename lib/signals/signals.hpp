#pragma once

// Our own trivially-copyable struct of every arrow in idl/. No generated or vendor type appears anywhere else:
// each vendor's codec copies field by field from the lists in signals/fields.hpp.
//
// Coordinates are the actuator's: a cylinder's piston position in m (from retracted), velocity in m/s and load-cell
// force in N. For a rotary motor the same fields hold rad, rad/s and Nm, which their names say.

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "core/time.hpp"
#include "signals/octets.hpp"
#include "signals/words.hpp"

namespace farrier::signals {

/// Number of topics a health report can count; larger than the registry, checked there.
inline constexpr int kMaxTopics = 24;

using Name = std::array<char, 24>;
using Text = std::array<char, 104>;

/// sim_bridge or hardware -> joint_node: one joint's sensors at one tick.
struct JointSensors {
  std::uint16_t joint = 0;              ///< key: the joint's number in the robot file
  Tick tick = kNoTick;                  ///< tick the sample was taken at
  std::int64_t sample_time_ns = 0;      ///< steady clock of the sampling computer
  double position_m_or_rad = 0;         ///< [0, stroke]
  double velocity_m_s_or_rad_s = 0;     ///< positive extends
  double force_N_or_Nm = 0;             ///< load cell, positive pushes the load towards extension
  std::uint32_t required_generation = 0;  ///< lock-step: gains the joint must hold before it acts on this tick
  std::uint32_t required_epoch = 0;     ///< lock-step: mode epoch the joint must know before it acts on this tick
};

/// Gait source or planner -> joint_node: the field's joint command (MIT Cheetah, Unitree, ODRI).
struct JointCommand {
  std::uint16_t joint = 0;          ///< key
  Tick tick = kNoTick;              ///< tick it is meant for
  std::int64_t sample_time_ns = 0;  ///< steady clock of the sender
  double position_rad = 0;
  double velocity_rad_s = 0;
  double torque_ff_Nm = 0;
  double stiffness_Nm_rad = 0;         ///< k_p >= 0
  double damping_Nms_rad = 0;          ///< k_d >= 0
  std::uint32_t announced_phases = 0;  ///< phase announcements of this joint's leg issued before this command
};

/// joint_node -> sim_bridge or hardware: the valve command that answers one sensor sample.
struct JointValveCommand {
  std::uint16_t joint = 0;          ///< key
  Tick tick = kNoTick;              ///< tick of the sensors it answers
  std::int64_t sample_time_ns = 0;  ///< sample time of the sensors it answers: carried through, so latency is measurable
  double valve_current_A = 0;       ///< within +- the valve's nominal current
  double force_reference_N_or_Nm = 0;
  std::uint32_t generation = 0;  ///< generation of the gains that acted
  std::uint32_t faults = 0;      ///< farrier::FaultSet bits
  std::uint8_t state = 0;        ///< JointState
  std::uint8_t phase = 0;        ///< Phase whose gains acted
};

/// joint_node -> estimator_service: what the joint measured and did at one tick.
struct JointMeasurement {
  std::uint16_t joint = 0;  ///< key
  Tick tick = kNoTick;
  std::int64_t sample_time_ns = 0;
  double position_m_or_rad = 0;
  double velocity_m_s_or_rad_s = 0;
  double force_N_or_Nm = 0;
  double valve_current_A = 0;  ///< applied from this tick on
  double force_reference_N_or_Nm = 0;
  std::uint32_t generation = 0;
  std::uint32_t faults = 0;
  std::uint8_t state = 0;
  std::uint8_t phase = 0;
};

/// estimator_service -> supervisor: the discrete model x[k+1] = A x[k] + B u[k] + c, SI units, states
/// (position, velocity, load-cell force), A row by row.
struct JointModelEstimate {
  std::uint16_t joint = 0;  ///< key
  Tick tick = kNoTick;      ///< of the newest measurement behind it
  std::uint8_t phase = 0;   ///< Phase whose dynamics it describes
  std::array<double, 9> a{};
  std::array<double, 3> b{};
  std::array<double, 3> c{};
  std::array<double, 9> a_error{};  ///< standard errors of a, one sigma, SI, >= 0
  std::array<double, 3> b_error{};  ///< of b
  double validity = 0;        ///< 0: not an estimate; 1: certain
  double excitation = 0;      ///< lower bound of the normalised information matrix's smallest eigenvalue, >= 0
  double prediction_error = 0;  ///< RMS error of force predictions over what the sensors' noise explains, >= 0
  double whiteness = 0;       ///< probability that white errors are at least as correlated as those, 0..1
  std::uint32_t samples = 0;  ///< informative ones behind it
  std::uint32_t flags = 0;    ///< Table F.1
  std::uint8_t has_physics = 0;               ///< 1: the estimator knows the joint's structure
  std::array<double, 8> physics{};            ///< plant::JointPhysics in the order of its declaration, SI
  std::array<double, 8> physics_error{};      ///< standard errors, >= 0; 0 for what is taken as known
};

/// supervisor -> joint_node: one slot of one joint's gains, in the thesis's normalised units (Fig. 7.1).
struct JointControllerGains {
  std::uint16_t joint = 0;      ///< key
  std::uint8_t phase = 0;       ///< key: Phase the gains are for
  std::uint32_t authority = 0;  ///< of the supervisor that issued them: a joint obeys the highest it has received
  std::uint32_t generation = 0; ///< rises by one with every issue to this joint; 0 is never issued
  Tick effective_tick = kNoTick;
  double k_position = 0;
  double k_velocity = 0;
  double k_force = 0;
  double k_integral = 0;
  double feed_forward = 0;
  double integral_factor = 0;            ///< xi of (7.11)
  std::array<double, 2> k_delay{};       ///< on the last valve commands, newest first
  std::uint8_t delay_ticks = 0;          ///< loop delay the gains were designed for, 0..2
  std::uint8_t compliant = 0;            ///< 1: designed without the position state (thesis 9.2.4)
  double position_scale_m_or_rad = 0;    ///< (3.52)
  double velocity_scale_m_s_or_rad_s = 0;
  double force_scale_N_or_Nm = 0;
  double current_scale_A = 0;            ///< (3.53)
  std::array<double, 9> model_a{};       ///< model they were designed for, SI, row by row
  std::array<double, 3> model_b{};
  std::uint8_t has_physics = 0;          ///< 1: physics is known, for controllers that invert the flow law
  std::array<double, 8> physics{};       ///< plant::JointPhysics in the order of its declaration, SI
};

/// supervisor -> monitors: gains redesigned from an estimate, or a design that was refused; published when it happens.
struct JointUpdateDecision {
  std::uint16_t joint = 0;              ///< key
  Tick tick = kNoTick;                  ///< at which it was decided
  std::uint8_t phase = 0;               ///< Phase whose slot of gains it concerns
  std::uint8_t verdict = 0;             ///< UpdateVerdict
  std::uint32_t generation = 0;         ///< of the gains issued, or of those that go on acting
  std::uint32_t estimate_samples = 0;   ///< JointModelEstimate::samples
  double validity = 0;                  ///< of the estimate, 0..1
  double excitation = 0;                ///< of the estimate, >= 0
  double prediction_error = 0;          ///< of the estimate, >= 0
  double whiteness = 0;                 ///< of the estimate, 0..1
  double pole_distance = 0;             ///< of the estimate's poles from those the acting gains are designed for, >= 0
  double pole_spread = 0;               ///< of the estimates' poles over the convergence window, >= 0
  std::uint32_t converged_ticks = 0;    ///< time for which the method's condition has held
  std::array<double, 3> poles_re{};     ///< of the estimate, z-plane, unit circle is 1
  std::array<double, 3> poles_im{};
  std::array<double, 3> designed_poles_re{};  ///< of the model the acting gains are designed for
  std::array<double, 3> designed_poles_im{};
  double estimated_radius = 0;          ///< spectral radius of the new gains' loop on the estimate; 0: not worked out
  double stored_radius = 0;             ///< on the stored model, worst corner of its uncertainty; 0: not worked out
  double disk_margin = 0;               ///< of the new gains' loop on the estimate, 0..2; 0: not worked out
  double delay_margin_s = 0;            ///< delay it tolerates on top of its own, >= 0; 0: not worked out
  std::uint32_t dwell_ticks = 0;        ///< least time in a phase with the joint's two slots; 0: none, or not worked out
  std::array<double, 9> model_a{};      ///< the estimate, SI, row by row
  std::array<double, 3> model_b{};
};

/// Gait source -> joint_node: a leg will change phase.
struct GaitPhase {
  std::uint16_t leg = 0;    ///< key
  std::uint32_t count = 0;  ///< announcements of this leg so far, this one included
  Tick announced_tick = kNoTick;
  Tick switch_tick = kNoTick;  ///< tick at which `phase` is planned to begin
  std::uint8_t phase = 0;      ///< Phase that begins
};

/// Every process -> every process: its identity, and whose samples it has received. Matched endpoints prove nothing.
struct SystemHello {
  std::uint16_t participant = 0;    ///< key
  std::uint64_t session = 0;        ///< one per run; others are ignored
  std::uint64_t contract = 0;       ///< hash of all topics, versions and fields: must be equal everywhere
  std::uint32_t pid = 0;
  std::uint8_t vendor = 0;          ///< bus::Vendor
  std::uint16_t routes_expected = 0;  ///< (reader, key) pairs this process must hear before it starts
  std::uint16_t routes_heard = 0;
  std::uint32_t authority = 0;      ///< highest that this process has received; 0: none
  std::uint32_t mode_epoch = 0;     ///< of the newest mode it has received; 0: none
  Name name{};
};

/// Every process -> supervisor, monitors, the run's launcher: its health, and its numbers of samples.
struct SystemHealth {
  std::uint16_t participant = 0;  ///< key
  Tick tick = kNoTick;
  std::uint8_t final_report = 0;  ///< 1: the last of this run
  std::uint64_t periods = 0;         ///< of the control loop that were stepped
  std::uint64_t missed_periods = 0;  ///< that passed without a step
  std::array<double, 4> latency_s{};  ///< sensor sample to valve command, p50, p99, p99.9, largest; sim_bridge only, 0 elsewhere
  std::array<double, 4> wake_up_s{};  ///< wake-up of the control loop after its deadline, likewise; 0 where it has none
  std::array<std::uint64_t, kMaxTopics> sent{};      ///< samples by topic number
  std::array<std::uint64_t, kMaxTopics> received{};  ///< samples by topic number
  std::array<std::uint64_t, kMaxTopics> lost{};      ///< samples known lost by topic number
};

/// Every process -> supervisor, monitors: something changed, and why.
struct SystemEvent {
  std::uint16_t participant = 0;  ///< key
  std::uint32_t count = 0;    ///< events of this participant so far
  Tick tick = kNoTick;
  std::uint8_t severity = 0;
  std::uint16_t joint = kNoJoint;  ///< 0xffff: not about one joint
  Text text{};
};

/// supervisor -> all: what the robot may do.
struct SystemMode {
  std::uint16_t robot = 0;     ///< key
  std::uint32_t authority = 0; ///< of the supervisor that issued it, from 1 on; rises when another takes over
  std::uint32_t epoch = 0;     ///< rises by one with every change; 0 is never issued
  std::uint64_t session = 0;   ///< a joint arms only for the session it was started in
  Tick effective_tick = kNoTick;
  std::uint8_t mode = 0;
};

/// Operator -> supervisor: asks for another mode.
struct SystemRequest {
  std::uint16_t robot = 0;    ///< key
  std::uint64_t session = 0;  ///< of the run it is meant for; others are ignored
  Tick tick = kNoTick;        ///< newest tick that the sender knows of
  std::uint32_t count = 0;    ///< requests of this sender so far, this one included
  std::uint8_t request = 0;   ///< Request
};

/// sim_bridge -> gait source, supervisor: tick k has begun (sensors of tick k are published).
struct ClockTick {
  std::uint16_t clock = 0;  ///< key
  Tick tick = kNoTick;
};

/// Lock-step, every process -> sim_bridge: all this process does in tick k is published.
struct ClockTickDone {
  std::uint16_t participant = 0;  ///< key
  Tick tick = kNoTick;
  std::uint32_t issued_gains = 0;   ///< samples of controller_gains this process has published so far
  std::uint32_t issued_modes = 0;   ///< samples of system/mode it has published so far
};

/// joint_node -> monitors: a joint's measurements and actions in the last fiftieth of a second, for slow networks and
/// eyes.
struct JointSummary {
  std::uint16_t joint = 0;  ///< key
  Tick tick = kNoTick;      ///< of the newest measurement in it; so are the numbers without another word
  std::int64_t sample_time_ns = 0;
  std::uint16_t ticks = 0;  ///< measurements in it; 0: none came, and the joint repeated its last one
  double position_m_or_rad = 0;
  double velocity_m_s_or_rad_s = 0;
  double force_N_or_Nm = 0;
  double force_reference_N_or_Nm = 0;
  double valve_current_A = 0;
  double force_error_rms_N_or_Nm = 0;      ///< of reference less force, over all of them
  double force_reference_rms_N_or_Nm = 0;  ///< over all of them
  std::uint32_t generation = 0;
  std::uint32_t faults = 0;  ///< that any of them had
  std::uint8_t state = 0;    ///< the most careful of any
  std::uint8_t phase = 0;
};

/// estimator_service -> monitors: one of ten or more estimates, for slow networks and eyes.
struct JointModelEstimateCopy : JointModelEstimate {};

/// Every process -> recorders: many samples of one of its streams at once, for recorders of everything. Each sample is
/// written as nanoseconds after the first one (4 bytes) and its CDR: signals/journal.hpp.
struct SystemJournal {
  std::uint16_t stream = 0;           ///< key: participant * kMaxTopics + number of the stream's topic
  std::uint64_t contract = 0;         ///< SystemHello::contract: what numbers of topics and bytes mean
  std::uint64_t samples_before = 0;   ///< in journals of this stream before this one
  Tick tick = kNoTick;                ///< of the newest sample in it
  std::uint32_t closed_after_ns = 0;  ///< from when its first sample was published until it was
  std::uint16_t samples = 0;
  Octets<32'000> bytes;
};

/// Copies as much of `text` as fits, always zero-terminated.
template <std::size_t kSize>
void assign(std::array<char, kSize>& to, std::string_view text) noexcept {
  to.fill('\0');
  text.copy(to.data(), kSize - 1);
}

/// Up to the terminating zero; all of it when a sender has left that out.
template <std::size_t kSize>
std::string_view text_of(const std::array<char, kSize>& from) noexcept {
  const auto end = std::find(from.begin(), from.end(), '\0');
  return std::string_view(from.data(), static_cast<std::size_t>(end - from.begin()));
}

}  // namespace farrier::signals
