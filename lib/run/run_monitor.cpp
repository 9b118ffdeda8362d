#include "run/run_monitor.hpp"

#include <algorithm>

#include "signals/tick_of.hpp"

namespace farrier::run {

Result<RunMonitor> RunMonitor::create(bus::Bus& bus, const participant::Identity& identity,
                                      const std::vector<std::string>& legs) {
  auto health = FARRIER_TRY(bus::Subscription<signals::SystemHealth>::create(
      bus, participant::endpoint_of(identity, bus::TopicId::kSystemHealth)));
  auto events = FARRIER_TRY(bus::Subscription<signals::SystemEvent>::create(
      bus, participant::endpoint_of(identity, bus::TopicId::kSystemEvent)));
  auto decisions = FARRIER_TRY(bus::Subscription<signals::JointUpdateDecision>::create(
      bus, participant::endpoint_of(identity, bus::TopicId::kJointUpdateDecision)));
  auto phases = FARRIER_TRY(
      bus::Subscription<signals::GaitPhase>::create(bus, participant::endpoint_of(identity, bus::TopicId::kGaitPhase)));
  RunMonitor monitor(std::move(health), std::move(events), std::move(decisions), std::move(phases),
                     identity.participants);
  if (!legs.empty()) {
    auto gains = FARRIER_TRY(bus::Subscription<signals::JointControllerGains>::create(
        bus, participant::endpoint_of(identity, bus::TopicId::kJointControllerGains, legs)));
    monitor.gains_in_ = std::move(gains);
  }
  return monitor;
}

void RunMonitor::poll(Tick now) {
  health_in_.drain([&](const signals::SystemHealth& health) {
    if (health.participant < healths_.size()) {
      healths_[health.participant] = health;
    }
  });
  event_in_.drain([&](const signals::SystemEvent& event) {
    events_.push_back(event);
    heard_.push_back(now);
  });
  decision_in_.drain([&](const signals::JointUpdateDecision& decision) {
    if (!signals::is_probe(decision)) {
      decisions_.push_back(decision);
    }
  });
  phase_in_.drain([&](const signals::GaitPhase& phase) {
    if (!signals::is_probe(phase)) {
      phases_.push_back(phase);
    }
  });
  if (gains_in_) {
    gains_in_->drain([&](const signals::JointControllerGains& gains) {
      if (gains.generation > 0) {  // else a probe of the greeting
        gains_.push_back(gains);
      }
    });
  }
}

bool RunMonitor::all_final() const noexcept {
  return std::all_of(healths_.begin(), healths_.end(), [](const auto& health) { return health.final_report != 0; });
}

}  // namespace farrier::run
