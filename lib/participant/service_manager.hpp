#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/time.hpp"

namespace farrier::participant {

/// Messages of a process to systemd, if systemd started it with Type=notify (sd_notify(3)). Otherwise it sends nothing.
/// Owned by one thread.
class ServiceManager {
 public:
  ServiceManager();
  /// Says that the process stops.
  ~ServiceManager();
  ServiceManager(const ServiceManager&) = delete;
  ServiceManager& operator=(const ServiceManager&) = delete;

  /// One line for `systemctl status`.
  void status(const std::string& text);

  /// Reports once that start-up is complete; the watchdog runs from then on.
  void ready();

  /// Feeds the watchdog four times per timeout, if every loop has turned since the last feeding. `turns`: number of
  /// turns of each loop; always of the same size. `now` is the steady clock.
  void alive(std::span<const std::uint64_t> turns, SteadyTime now);

 private:
  Nanoseconds feeding_period_{0};  ///< 0: no watchdog
  SteadyTime next_feeding_{};
  std::vector<std::uint64_t> fed_at_;
  bool ready_ = false;
};

}  // namespace farrier::participant
