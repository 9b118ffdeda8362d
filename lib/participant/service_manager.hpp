#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/time.hpp"

namespace farrier::participant {

/// What a process tells systemd that started it with Type=notify (sd_notify(3)); nothing where nobody asked. Owned by
/// one thread.
class ServiceManager {
 public:
  ServiceManager();
  /// Says that the process stops.
  ~ServiceManager();
  ServiceManager(const ServiceManager&) = delete;
  ServiceManager& operator=(const ServiceManager&) = delete;

  /// One line for `systemctl status`.
  void status(const std::string& text);

  /// Says, once, that start-up is complete; the watchdog runs from then on.
  void ready();

  /// Feeds the watchdog, four times in the time it has, when every one of the loops has turned since it was last fed.
  /// `turns`: how often each has, always the same number of them. `now` is the steady clock.
  void alive(std::span<const std::uint64_t> turns, SteadyTime now);

 private:
  Nanoseconds feeding_period_{0};  ///< 0: no watchdog
  SteadyTime next_feeding_{};
  std::vector<std::uint64_t> fed_at_;
  bool ready_ = false;
};

}  // namespace farrier::participant
