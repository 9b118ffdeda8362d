#pragma once

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "core/time.hpp"
#include "runtime/realtime_thread.hpp"

namespace farrier::cli {

/// From the time at which a thread was due to wake up to the time at which it did.
struct Pause {
  SteadyTime begin, end;
};

/// Detects pauses of this computer. A thread on each processor sleeps for a millisecond repeatedly, by default above
/// all threads of a run. If the limits forbid its priority, it reports pauses that are only preemptions.
class PauseWatch {
 public:
  explicit PauseWatch(int priority = runtime::kWatchPriority);
  ~PauseWatch();
  PauseWatch(const PauseWatch&) = delete;
  PauseWatch& operator=(const PauseWatch&) = delete;

  void forget();
  /// Pauses of more than `at_least` (>= 1 ms) of any thread since the last call of forget().
  std::vector<Pause> longer_than(Nanoseconds at_least) const;
  /// 0: none was longer than a millisecond.
  Nanoseconds longest() const;

 private:
  void watch(int processor, int priority);

  mutable std::mutex mutex_;
  std::vector<Pause> pauses_;
  std::atomic<bool> ends_{false};
  std::vector<std::thread> threads_;
};

}  // namespace farrier::cli
