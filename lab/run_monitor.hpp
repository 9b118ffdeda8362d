#pragma once

#include <memory>
#include <vector>

#include "participant/participant.hpp"

namespace farrier::lab {

/// Listens to the health and the events of a run. Only adds readers.
class RunMonitor {
 public:
  static Result<RunMonitor> create(bus::Bus& bus, const participant::Identity& identity);

  /// Takes what has come.
  void poll();

  /// Newest health of every participant, by number; tick kNoTick: none yet.
  const std::vector<signals::SystemHealth>& healths() const noexcept { return healths_; }
  /// True when every participant has sent its final report.
  bool all_final() const noexcept;
  const std::vector<signals::SystemEvent>& events() const noexcept { return events_; }

 private:
  RunMonitor(bus::Subscription<signals::SystemHealth> health, bus::Subscription<signals::SystemEvent> events,
             std::size_t participants)
      : health_in_(std::move(health)), event_in_(std::move(events)), healths_(participants) {}

  bus::Subscription<signals::SystemHealth> health_in_;
  bus::Subscription<signals::SystemEvent> event_in_;
  std::vector<signals::SystemHealth> healths_;
  std::vector<signals::SystemEvent> events_;
};

}  // namespace farrier::lab
