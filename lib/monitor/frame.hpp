#pragma once

// A monitor's view of a robot at one moment. The terminal, the page and Prometheus all show frames, of a running robot
// and of a recording alike.

#include <array>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "body/model/body_model.hpp"
#include "signals/signals.hpp"

namespace farrier::monitor {

/// A joint or process whose summaries, fifty a second, are older than this counts as silent.
inline constexpr double kSilent_s = 1.0;

/// One joint. A value that has not come yet is empty, or has the tick kNoTick or the generation 0.
struct JointFrame {
  std::vector<signals::JointSummary> summaries;  ///< that came since the last frame, oldest first
  signals::JointSummary newest;                  ///< summary
  double age_s = 0.0;                            ///< since it came; infinite before the first
  double rate_Hz = 0.0;              ///< control ticks per second of this monitor's clock, over the last second
  std::uint64_t missed_ticks = 0;    ///< of control that are in no summary, since the first
  double force_error_rms = 0.0;      ///< reference less force over the last second, N or Nm
  double force_reference_rms = 0.0;  ///< over the last second, N or Nm
  std::uint32_t faults = 0;          ///< farrier::FaultSet bits: any since the last frame
  PerPhase<signals::JointControllerGains> gains{};  ///< newest, by phase
  signals::JointModelEstimate estimate;             ///< newest
  std::array<std::complex<double>, 3> poles{};      ///< of the estimate, z-plane, largest modulus first
  std::optional<double> mass_kg_or_kgm2;            ///< of the load, as the estimate has it
  signals::JointUpdateDecision decision;            ///< newest
  std::uint32_t redesigns = 0;                      ///< decisions to redesign, since the first sample

  /// RMS error over RMS reference over the last second; empty without a reference.
  std::optional<double> nrmse() const noexcept {
    return force_reference_rms > 0.0 ? std::optional(force_error_rms / force_reference_rms) : std::nullopt;
  }
};

/// One leg: changes of phase that its joints were told, since the first sample.
struct LegFrame {
  std::uint64_t planned_switches = 0;
  std::uint64_t felt_switches = 0;  ///< touchdowns that locomotion felt before their plan
};

/// One process of the run.
struct ParticipantFrame {
  signals::SystemHello hello;
  signals::SystemHealth health;  ///< tick kNoTick: none yet
  double age_s = 0.0;            ///< since its health came; infinite before the first

  std::uint64_t lost() const noexcept {  ///< samples that it knows to be lost, over all topics
    std::uint64_t sum = 0;
    for (const std::uint64_t one : health.lost) {
      sum += one;
    }
    return sum;
  }
};

/// The whole robot in space. Vectors are in the trunk's frame: x forward, y left, z up from the trunk's origin.
struct BodyFrame {
  struct Leg {
    std::array<Eigen::Vector3d, body::kJointsPerLeg> hinges_m;  ///< from the trunk outwards
    Eigen::Vector3d foot_m;                                     ///< centre of its sphere
  };
  std::vector<std::optional<Leg>> legs;     ///< by number; empty: a joint of it has not been heard
  Eigen::Vector3d centre_of_mass_m;         ///< of the whole robot; NaN while a leg is not known
  std::optional<signals::BodyTruth> truth;  ///< of a simulation; empty while none is heard
  std::optional<signals::BodyState> state;  ///< as locomotion believes it; empty while none is heard
};

/// The hydraulic supply that all joints share.
struct SupplyFrame {
  signals::SupplyState newest;
  std::optional<signals::SupplyTruth> newest_truth;  ///< of a simulation; empty while none is heard
  std::vector<signals::SupplyState> states;          ///< since the last frame, oldest first, fifty a second
  std::vector<signals::SupplyTruth> truths;          ///< likewise
};

/// A change of state with its cause. Events of the robot's processes, and the monitor's own.
struct EventFrame {
  std::uint64_t number = 0;  ///< from 0 on, in the order in which they came
  double time_s = 0.0;       ///< since the first sample
  Tick tick = kNoTick;
  signals::Severity severity{};
  std::string who;    ///< the process; "monitor": this one
  std::string joint;  ///< empty: not about one joint
  std::string text;
};

struct Frame {
  double time_s = 0.0;                         ///< since the first sample came; by the recorder's clock in a recording
  Tick tick = kNoTick;                         ///< newest heard of
  double age_s = 0.0;                          ///< since any sample came; infinite before the first
  signals::SystemMode mode;                    ///< epoch 0: none yet
  std::vector<signals::Phase> phases;          ///< by leg, as announced for `tick`
  std::vector<LegFrame> legs;                  ///< by number
  std::vector<JointFrame> joints;              ///< by number
  std::vector<ParticipantFrame> participants;  ///< by number; a hello of tick-less default: not heard of
  std::optional<BodyFrame> body;               ///< of a robot whose file describes rigid bodies
  std::optional<SupplyFrame> supply;           ///< empty while none is heard
  std::vector<EventFrame> events;              ///< since the last frame
  std::uint64_t lost_samples = 0;              ///< on the way to this monitor, as far as it can tell
};

}  // namespace farrier::monitor
