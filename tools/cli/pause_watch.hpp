#pragma once

#include <atomic>
#include <thread>
#include <vector>

#include "core/time.hpp"
#include "runtime/realtime_thread.hpp"

namespace farrier::cli {

/// Watches whether this computer stands still: a thread on each processor, above all others of a run unless told
/// otherwise, that sleeps a millisecond again and again. Where the limits forbid its priority it takes for a pause what is
/// none.
class PauseWatch {
 public:
  explicit PauseWatch(int priority = runtime::kWatchPriority);
  ~PauseWatch();
  PauseWatch(const PauseWatch&) = delete;
  PauseWatch& operator=(const PauseWatch&) = delete;

  void forget() noexcept { longest_ns_ = 0; }
  /// The longest that one of them woke up late since it was told to forget.
  Nanoseconds longest() const noexcept { return Nanoseconds(longest_ns_.load()); }

 private:
  void watch(int processor, int priority) noexcept;

  std::atomic<std::int64_t> longest_ns_{0};
  std::atomic<bool> ends_{false};
  std::vector<std::thread> threads_;
};

}  // namespace farrier::cli
