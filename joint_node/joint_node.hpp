#pragma once

// One joint's torque loop (thesis Fig. 1.3 around Fig. 7.1):
//
//   joint/command ──▶ tau_ref = tau_ff + k_p (q_ref − q) + k_d (q̇_ref − q̇) ──▶ F_ref = tau_ref / lever(q) ──▶ LQR-I ──▶ valve
//   joint/sensors ──▶ q = angle(x), q̇ = v / lever(q) ───────────────────────────────────▲ (x, v, F)      ▲── dither.
//
// The dither is added to the controller's output while the joint tracks. Gains from joint/controller_gains enter the
// slot of their phase and act from their effective tick. The announced gait/phase selects the acting slot, stance a
// little early.
//
// A joint whose kind is feedback_linearisation or pid has the nominal flow law or a PID in place of LQR-I, and needs no
// gains. One of kind flow_inversion has FlowInversion there, with the physics that come with the gains. Effects of the
// joint's file are compensated: sensors are corrected before they are read, and the current passes their inverse
// (control/effect_compensation.hpp). Where the file asks for it, the controller's measurements lag alike
// (control/law/filter_equaliser.hpp). Without a force signal the joint creeps back to where it lost it, with the valve
// as a source of speed. The safety table (core/fault.hpp) has the reactions to missing inputs.

#include <array>
#include <optional>

#include "control/law/delay_predictor.hpp"
#include "control/law/effect_compensation.hpp"
#include "control/law/filter_equaliser.hpp"
#include "control/law/feedback_linearisation.hpp"
#include "control/law/flow_inversion.hpp"
#include "control/law/force_controller.hpp"
#include "control/law/pid.hpp"
#include "core/fault.hpp"
#include "core/noise.hpp"
#include "joint_node/fault_assessor.hpp"
#include "joint_node/sensor_check.hpp"
#include "joint_node/upcoming.hpp"
#include "robot/robot.hpp"
#include "signals/signals.hpp"

namespace farrier::joint_node {

/// One joint of a joint_node process. No clock, no I/O, no allocation after construction.
class JointNode {
 public:
  /// `loop_delay_ticks`: from a sample to the first valve command that depends on it. `session`: only a mode of this
  /// session arms the joint.
  JointNode(const robot::Joint& joint, const robot::Safety& safety, double period_s, int loop_delay_ticks,
            std::uint64_t session);

  /// Puts checked gains (check_gains) into the slot of their phase; they act from effective_tick on. Returns false and
  /// leaves the slot unchanged if they are not newer than the slot's, by authority and then generation. Also returns
  /// false for gains of an older authority than any stored before: their supervisor has been replaced.
  bool store_gains(const signals::JointControllerGains& signal, const control::Gains& gains) noexcept;

  /// Records that a gain update failed its check: the joint reports it from the update's effective tick until the next
  /// good one acts. The last good gains keep acting.
  void refuse_gains(const signals::JointControllerGains& signal) noexcept;

  void set_mode(const signals::SystemMode& mode) noexcept;

  /// The leg changes phase at the announced tick, or at once if that has passed. The gains of stance act
  /// Safety::stance_lead_s sooner than announced, rounded to whole periods. Unknown phases are ignored.
  void announce_phase(const signals::GaitPhase& phase) noexcept;

  struct Inputs {
    Tick tick = kNoTick;            ///< control tick; selects gains, phase and mode that are due
    signals::JointSensors sensors;  ///< the newest available
    double sensors_age_s = 0;       ///< since an undelayed one would have arrived; infinite for none
    signals::JointCommand command;  ///< the newest available
    double command_age_s = 0;       ///< since an undelayed one would have arrived; infinite for none
    double since_last_step_s = 0;   ///< 0 for the first
  };
  struct Outputs {
    signals::JointValveCommand valve;
    signals::JointMeasurement measurement;
  };

  /// Runs one control period. Always returns a valve command within the valve's limits.
  Outputs step(const Inputs& inputs) noexcept;

  FaultSet faults() const noexcept { return faults_; }
  std::uint16_t joint() const noexcept { return joint_.number; }

  /// Newest generation known for any slot: acting, waiting or refused.
  std::uint32_t newest_generation() const noexcept;

 private:
  /// Order of the gains of a joint: by the issuer's authority, then by generation; 0: none.
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

  /// True if both are of one generation and act alike.
  static bool same(const Slot& one, const Slot& other) noexcept;
  void apply_due(Tick tick) noexcept;
  void assess(const Inputs& inputs) noexcept;
  control::ForceReference force_reference(const control::Measurement& measured, const signals::JointCommand& command,
                                          signals::JointState state) noexcept;
  double dither_A(Tick tick) const noexcept;
  double valve_current(const control::ForceReference& reference, const control::Measurement& measured,
                       double probe_A) noexcept;
  double valve_current_by_gains(double reference, const control::Measurement& measured, double probe_A) noexcept;
  double valve_current_by_physics(const control::ForceReference& reference, const control::Measurement& measured,
                                  double probe_A) noexcept;
  void take_valve_physics() noexcept;
  /// Current of a controller without gains, with the probe and within the valve's limits.
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
  control::FilterEqualiser equaliser_;
  control::DelayPredictor predictor_;
  control::ForceController controller_;
  control::Measurement last_measured_{};                    ///< of the controller's last step
  double last_reference_ = 0.0;                             ///< of the controller's last step, N or Nm
  std::optional<control::FeedbackLinearisation> flow_law_;  ///< where the joint is of that kind
  control::Pid pid_;
  std::optional<control::FlowInversion> flow_inversion_;  ///< likewise
  PerPhase<Slot> acting_{};
  PerPhase<Upcoming<Slot, &Slot::issue, &Slot::effective_tick>> upcoming_gains_{};
  std::uint32_t newest_authority_ = 0;  ///< of gains
  PerPhase<Refusal> refused_{};
  PerPhase<Upcoming<Refusal, &Refusal::issue, &Refusal::effective_tick>> upcoming_refusals_{};
  signals::SystemMode mode_{};
  Upcoming<signals::SystemMode, &signals::SystemMode::epoch, &signals::SystemMode::effective_tick> upcoming_modes_;
  Upcoming<signals::GaitPhase, &signals::GaitPhase::count, &signals::GaitPhase::switch_tick> upcoming_phases_;
  signals::Phase phase_ = signals::Phase::kStance;
  std::uint32_t phase_count_ = 0;  ///< of the announcement in effect; 0: none
  Issue controller_issue_ = 0;     ///< of the gains the controller runs with; 0: none
  signals::Phase controller_phase_ = signals::Phase::kStance;
  FaultSet faults_;
  SensorCheck sensor_check_;
  FaultAssessor fault_assessor_;
  double held_position_ = 0.0;  ///< where the force was lost, m or rad
};

}  // namespace farrier::joint_node
