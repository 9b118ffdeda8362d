#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "participant/participant.hpp"

namespace farrier::run {

/// Listens to the health, the events, the changes of phase, the gains and the decisions about gains of a run. Only adds
/// readers.
class RunMonitor {
 public:
  /// `legs`: names of those of whose joints it collects gains; none: no gains.
  static Result<RunMonitor> create(bus::Bus& bus, const participant::Identity& identity,
                                   const std::vector<std::string>& legs = {});

  /// Takes what has come. `now`: newest tick that the caller knows of.
  void poll(Tick now = kNoTick);

  /// Newest health of every participant, by number; tick kNoTick: none yet.
  const std::vector<signals::SystemHealth>& healths() const noexcept { return healths_; }
  /// True when every participant has sent its final report.
  bool all_final() const noexcept;
  const std::vector<signals::SystemEvent>& events() const noexcept { return events_; }
  /// `now` of the polls in which they came.
  const std::vector<Tick>& heard() const noexcept { return heard_; }
  /// In the order in which they came: of one joint in that of their ticks.
  const std::vector<signals::JointUpdateDecision>& decisions() const noexcept { return decisions_; }
  /// Every update that was issued, in the order in which they came; between two polls only the newest of a slot.
  const std::vector<signals::JointControllerGains>& gains() const noexcept { return gains_; }

  /// Changes of phase that joints were told, in the order in which they came.
  const std::vector<signals::GaitPhase>& phases() const noexcept { return phases_; }

 private:
  RunMonitor(bus::Subscription<signals::SystemHealth> health, bus::Subscription<signals::SystemEvent> events,
             bus::Subscription<signals::JointUpdateDecision> decisions, bus::Subscription<signals::GaitPhase> phases,
             std::size_t participants)
      : health_in_(std::move(health)),
        event_in_(std::move(events)),
        decision_in_(std::move(decisions)),
        phase_in_(std::move(phases)),
        healths_(participants) {}

  bus::Subscription<signals::SystemHealth> health_in_;
  bus::Subscription<signals::SystemEvent> event_in_;
  bus::Subscription<signals::JointUpdateDecision> decision_in_;
  bus::Subscription<signals::GaitPhase> phase_in_;
  std::optional<bus::Subscription<signals::JointControllerGains>> gains_in_;
  std::vector<signals::SystemHealth> healths_;
  std::vector<signals::SystemEvent> events_;
  std::vector<Tick> heard_;  ///< by event
  std::vector<signals::JointUpdateDecision> decisions_;
  std::vector<signals::JointControllerGains> gains_;
  std::vector<signals::GaitPhase> phases_;
};

}  // namespace farrier::run
