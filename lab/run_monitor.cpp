#include "lab/run_monitor.hpp"

#include <algorithm>

namespace farrier::lab {

Result<RunMonitor> RunMonitor::create(bus::Bus& bus, const participant::Identity& identity) {
  auto health = bus::Subscription<signals::SystemHealth>::create(
      bus, participant::endpoint_of(identity, bus::TopicId::kSystemHealth));
  if (!health) {
    return health.error();
  }
  auto events = bus::Subscription<signals::SystemEvent>::create(
      bus, participant::endpoint_of(identity, bus::TopicId::kSystemEvent));
  if (!events) {
    return events.error();
  }
  return RunMonitor(std::move(health).value(), std::move(events).value(), identity.participants);
}

void RunMonitor::poll() {
  health_in_.drain([&](const signals::SystemHealth& health) {
    if (health.participant < healths_.size()) {
      healths_[health.participant] = health;
    }
  });
  event_in_.drain([&](const signals::SystemEvent& event) { events_.push_back(event); });
}

bool RunMonitor::all_final() const noexcept {
  return std::all_of(healths_.begin(), healths_.end(), [](const auto& health) { return health.final_report != 0; });
}

}  // namespace farrier::lab
