#pragma once

#include <atomic>

#include "core/spsc_ring.hpp"
#include "participant/realtime_loop.hpp"
#include "runtime/latency_histogram.hpp"
#include "signals/signals.hpp"

namespace farrier::participant {

/// Deadline misses and latencies of a loop on deadlines, for the health report of its process.
class LoopStatistics {
 public:
  /// Control thread, once per step.
  void stepped(const Wake& wake) noexcept {
    periods_.fetch_add(1, std::memory_order_relaxed);
    missed_.fetch_add(wake.missed, std::memory_order_relaxed);
    wake_ups_.push(wake.now - wake.due);
  }
  /// Bus thread: the answer to the sample of this time has come.
  void answered(std::int64_t sampled_ns, SteadyTime now) noexcept {
    latency_.add(now.time_since_epoch() - Nanoseconds(sampled_ns));
  }
  /// Bus thread. Call it at least every 256 periods, or wake-ups are not counted.
  void fill(signals::SystemHealth& health) noexcept {
    for (Nanoseconds wake_up; wake_ups_.pop(wake_up);) {
      wake_up_.add(wake_up);
    }
    health.periods = periods_.load(std::memory_order_relaxed);
    health.missed_periods = missed_.load(std::memory_order_relaxed);
    health.latency_s = latency_.summary_s();
    health.wake_up_s = wake_up_.summary_s();
  }

 private:
  std::atomic<std::uint64_t> periods_{0}, missed_{0};
  SpscRing<Nanoseconds, 256> wake_ups_;
  runtime::LatencyHistogram latency_, wake_up_;  ///< bus thread
};

}  // namespace farrier::participant
