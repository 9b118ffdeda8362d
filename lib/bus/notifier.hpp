#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace farrier::bus {

/// Counts arrivals of a bus and lets one thread sleep until enough of them have come. Transports call arrived()
/// from their receive threads; it takes a lock only for the count and wakes nobody before the sleeper's target.
class Notifier {
 public:
  void arrived() noexcept;

  /// Wakes the sleeper whatever it waits for.
  void wake() noexcept;

  std::uint64_t arrivals() const noexcept;

  /// Sleeps until arrivals() >= target, wake(), or the timeout.
  void wait_for_arrivals(std::uint64_t target, std::chrono::nanoseconds timeout) noexcept;

 private:
  mutable std::mutex mutex_;
  std::condition_variable reached_;
  std::uint64_t arrivals_ = 0;
  std::uint64_t target_ = UINT64_MAX;
  bool woken_ = false;
};

}  // namespace farrier::bus
