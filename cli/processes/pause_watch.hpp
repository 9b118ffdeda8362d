#pragma once

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "core/time.hpp"
#include "runtime/realtime_thread.hpp"

namespace farrier::cli {

/// From when a thread was to wake up to when it did.
struct Pause {
  SteadyTime begin, end;
};

/// Watches whether this computer stands still: a thread on each processor, above all others of a run unless told
/// otherwise, that sleeps a millisecond again and again. Where the limits forbid its priority it takes for a pause what is
/// none.
class PauseWatch {
 public:
  explicit PauseWatch(int priority = runtime::kWatchPriority);
  ~PauseWatch();
  PauseWatch(const PauseWatch&) = delete;
  PauseWatch& operator=(const PauseWatch&) = delete;

  void forget();
  /// Each time that one of them woke up more than `at_least` late, which is a millisecond or more, since the watch was
  /// told to forget.
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
