#pragma once

// One joint's torque loop (thesis Fig. 1.3 around Fig. 7.1):
//
//   joint/command ──▶ tau_ref = tau_ff + k_p (q_ref − q) + k_d (q̇_ref − q̇) ──▶ F_ref = tau_ref / lever(q) ──▶ LQR-I ──▶ valve
//   joint/sensors ──▶ q = angle(x), q̇ = v / lever(q) ───────────────────────────────────▲ (x, v, F)
//                                                          dither while tracking, added to what the controller asks for ──▲
//   controller_gains ──▶ slot per phase, acts from its effective tick      gait/phase ──▶ which slot acts, stance a little early
//
// A joint whose kind is feedback_linearisation or pid has the nominal flow law or a PID in place of LQR-I, and needs no
// gains. One of kind flow_inversion has FlowInversion there, with the physics that come with the gains.
// Effects that the joint's file has stand between: sensors are corrected before anything reads them, and the current
// goes through their inverse (control/effect_compensation.hpp).
// Without a force to close the loop with it creeps back to where it lost it: the valve as a source of speed.
// What it does when something is missing is the table in docs/architecture.md.

#include <array>
#include <optional>

#include "control/law/delay_predictor.hpp"
#include "control/law/effect_compensation.hpp"
#include "control/law/feedback_linearisation.hpp"
#include "control/law/flow_inversion.hpp"
#include "control/law/force_controller.hpp"
#include "control/law/pid.hpp"
#include "core/fault.hpp"
#include "core/noise.hpp"
#include "joint_node/sensor_check.hpp"
#include "joint_node/upcoming.hpp"
#include "robot/robot.hpp"
#include "signals/signals.hpp"

namespace farrier::joint_node {

/// One joint of a joint_node process. No clock, no I/O, no allocation after construction.
class JointNode {
 public:
  /// `loop_delay_ticks`: from a sample to the first valve command that knows it. `session`: only a mode of this session
  /// arms the joint.
  JointNode(const robot::Joint& joint, const robot::Safety& safety, double period_s, int loop_delay_ticks,
            std::uint64_t session);

  /// Puts checked gains (check_gains) into the slot of their phase; they act from effective_tick on.
  /// False, and the slot keeps what it has, when they are not newer than the slot's, by authority and then generation, or
  /// of an older authority than any gains stored before: their supervisor has been replaced.
  bool store_gains(const signals::JointControllerGains& signal, const control::Gains& gains) noexcept;

  /// A gain update failed its check: from its effective tick the joint says so, until the next good one acts; the last
  /// good gains go on acting all the while.
  void refuse_gains(const signals::JointControllerGains& signal) noexcept;

  void set_mode(const signals::SystemMode& mode) noexcept;

  /// The leg changes phase at the announced tick, at once when it has gone by; the gains of stance act
  /// Safety::stance_lead_s sooner than announced, rounded to whole periods. Phases there are not are ignored.
  void announce_phase(const signals::GaitPhase& phase) noexcept;

  struct Inputs {
    Tick tick = kNoTick;              ///< control tick; selects gains, phase and mode that are due
    signals::JointSensors sensors;    ///< the newest there is
    double sensors_age_s = 0;         ///< since it was received; infinite when there was none
    signals::JointCommand command;    ///< the newest there is
    double command_age_s = 0;         ///< since it was received; infinite when there was none
    double since_last_step_s = 0;     ///< 0 for the first
  };
  struct Outputs {
    signals::JointValveCommand valve;
    signals::JointMeasurement measurement;
  };

  /// One control period. Always answers with a valve command within the valve's limits.
  Outputs step(const Inputs& inputs) noexcept;

  FaultSet faults() const noexcept { return faults_; }
  std::uint16_t joint() const noexcept { return joint_.number; }

  /// Newest generation heard of for any slot: acting, waiting or refused.
  std::uint32_t newest_generation() const noexcept;

 private:
  /// Order of the gains of a joint: by the authority of who issued them, then by generation; 0: none.
  using Issue = std::uint64_t;
  static Issue issue_of(const signals::JointControllerGains& signal) noexcept {
    return (static_cast<Issue>(signal.authority) << 32) | signal.generation;
  }
  static std::uint32_t generation_of(Issue issue) noexcept { return static_cast<std::uint32_t>(issue); }

  struct Slot {
    control::Gains gains{};
    plant::JointPhysics physics{};
    Issue issue = 0;
    Tick effective_tick = kNoTick;
  };
  /// A gain update that failed its check.
  struct Refusal {
    Issue issue = 0;
    Tick effective_tick = kNoTick;
  };

  /// Whether they are of one generation and act alike.
  static bool same(const Slot& one, const Slot& other) noexcept;
  void apply_due(Tick tick) noexcept;
  void assess(const Inputs& inputs) noexcept;
  signals::JointState state() const noexcept;
  control::ForceReference force_reference(const control::Measurement& measured, const signals::JointCommand& command,
                                          signals::JointState state) noexcept;
  double dither_A(Tick tick) const noexcept;
  double valve_current(const control::ForceReference& reference, const control::Measurement& measured,
                       double probe_A) noexcept;
  double valve_current_by_gains(double reference, const control::Measurement& measured, double probe_A) noexcept;
  double valve_current_by_physics(const control::ForceReference& reference, const control::Measurement& measured,
                                  double probe_A) noexcept;
  /// What a controller without gains asks for, with the probe and within the valve's limits.
  double probed(double asked_A, bool saturated, double probe_A) noexcept;
  double holding_current(double position) noexcept;
  void reset_controller() noexcept;

  robot::Joint joint_;
  robot::Safety safety_;
  std::uint64_t session_;
  Tick stance_lead_ticks_;
  double home_position_;  ///< m or rad
  double dither_amplitude_A_;
  NoiseStream dither_sign_;  ///< by tick / hold
  control::EffectCompensation compensation_;
  control::DelayPredictor predictor_;
  control::ForceController controller_;
  control::Measurement last_measured_{};  ///< of the controller's last step
  double last_reference_ = 0.0;           ///< of the controller's last step, N or Nm
  std::optional<control::FeedbackLinearisation> flow_law_;  ///< where the joint is of that kind
  control::Pid pid_;
  std::optional<control::FlowInversion> flow_inversion_;    ///< likewise
  std::array<Slot, signals::kPhaseCount> acting_{};
  std::array<Upcoming<Slot, &Slot::issue, &Slot::effective_tick>, signals::kPhaseCount> upcoming_gains_{};
  std::uint32_t newest_authority_ = 0;  ///< of gains
  std::array<Refusal, signals::kPhaseCount> refused_{};
  std::array<Upcoming<Refusal, &Refusal::issue, &Refusal::effective_tick>, signals::kPhaseCount>
      upcoming_refusals_{};
  signals::SystemMode mode_{};
  Upcoming<signals::SystemMode, &signals::SystemMode::epoch, &signals::SystemMode::effective_tick> upcoming_modes_;
  Upcoming<signals::GaitPhase, &signals::GaitPhase::count, &signals::GaitPhase::switch_tick> upcoming_phases_;
  signals::Phase phase_ = signals::Phase::kStance;
  Issue controller_issue_ = 0;  ///< of the gains the controller runs with; 0: none
  signals::Phase controller_phase_ = signals::Phase::kStance;
  FaultSet faults_;
  std::uint32_t tripped_epoch_ = 0;
  SensorCheck sensor_check_;
  double held_position_ = 0.0;  ///< where the force was lost, m or rad
};

}  // namespace farrier::joint_node
