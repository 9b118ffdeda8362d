#include "participant/service_manager.hpp"

#include <systemd/sd-daemon.h>

#include <algorithm>
#include <functional>

#include "participant/clock.hpp"

namespace farrier::participant {
namespace {

constexpr int kKeepEnvironment = 0;
constexpr int kFeedingsPerTimeout = 4;

// A notification that cannot be sent is no reason to stop controlling a robot.
void notify(const std::string& state) { static_cast<void>(sd_notify(kKeepEnvironment, state.c_str())); }

}  // namespace

ServiceManager::ServiceManager() {
  std::uint64_t timeout_us = 0;
  if (sd_watchdog_enabled(kKeepEnvironment, &timeout_us) > 0) {
    feeding_period_ = std::chrono::microseconds(timeout_us) / kFeedingsPerTimeout;
  }
}

ServiceManager::~ServiceManager() { notify("STOPPING=1"); }

void ServiceManager::status(const std::string& text) { notify("STATUS=" + text); }

void ServiceManager::ready() {
  if (!ready_) {
    ready_ = true;
    notify("READY=1\nSTATUS=running");
  }
}

void ServiceManager::alive(std::span<const std::uint64_t> turns, SteadyTime now) {
  const SteadyTime machine_now = machine_time(now);
  if (feeding_period_ == Nanoseconds(0) || machine_now < next_feeding_) {
    return;
  }
  fed_at_.resize(turns.size(), 0);
  const bool all_turned = std::equal(turns.begin(), turns.end(), fed_at_.begin(), std::greater<>());
  if (all_turned) {
    next_feeding_ = machine_now + feeding_period_;
    fed_at_.assign(turns.begin(), turns.end());
    notify("WATCHDOG=1");
  }
}

}  // namespace farrier::participant
