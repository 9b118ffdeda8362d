#pragma once

#include <atomic>
#include <thread>

#include "core/spsc_ring.hpp"
#include "record/trace.hpp"

namespace farrier::sim_bridge {

/// Writes a trace on a thread of its own, without priority: a disk may take its time, on which nothing else waits.
class TraceThread {
 public:
  explicit TraceThread(record::TraceWriter writer);
  /// Writes what has come.
  ~TraceThread();
  TraceThread(const TraceThread&) = delete;
  TraceThread& operator=(const TraceThread&) = delete;

  /// Control thread. A row is lost where the disk is behind by thousands of them.
  void push(const record::TraceRow& row) noexcept { static_cast<void>(rows_.push(row)); }
  /// Control thread: no more rows come.
  void end() noexcept { ended_.store(true, std::memory_order_release); }

  /// Whether all rows before end() are in the file, or lost.
  bool finished() const noexcept { return finished_.load(std::memory_order_acquire); }
  /// Whether none was lost; of a trace that is finished.
  bool complete() const noexcept { return rows_.dropped() == 0 && !refused_.load(std::memory_order_relaxed); }

 private:
  void run();

  record::TraceWriter writer_;
  SpscRing<record::TraceRow, 16384> rows_;
  std::atomic<bool> ended_{false}, finished_{false}, refused_{false};
  std::thread thread_;
};

}  // namespace farrier::sim_bridge
