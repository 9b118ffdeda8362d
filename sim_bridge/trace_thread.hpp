#pragma once

#include <array>
#include <atomic>
#include <thread>

#include "core/spsc_ring.hpp"
#include "trace/trace.hpp"

namespace farrier::sim_bridge {

/// Writes a trace to the disk on a thread of its own, without priority: a slow disk blocks nothing else.
class TraceThread {
 public:
  explicit TraceThread(trace::TraceWriter writer);
  /// Writes all rows that have come.
  ~TraceThread();
  TraceThread(const TraceThread&) = delete;
  TraceThread& operator=(const TraceThread&) = delete;

  /// For one thread only. Rows are lost if the disk is behind by kBlocks: a second and a half of twelve joints at 1
  /// kHz.
  void write(const trace::TraceRow& row) noexcept;
  /// Call on the same thread: no more rows come.
  void end() noexcept;

  /// True if all rows before end() are in the file, or lost.
  bool finished() const noexcept { return finished_.load(std::memory_order_acquire); }
  /// True if no row was lost; only valid for a finished trace.
  bool complete() const noexcept { return blocks_.dropped() == 0 && !refused_.load(std::memory_order_relaxed); }

 private:
  struct Block {
    std::size_t size = 0;
    std::array<char, 4096 - sizeof size> lines;
  };
  static constexpr std::size_t kBlocks = 1024;

  void hand_over() noexcept;
  void run();

  trace::TraceWriter writer_;
  Block filling_;  ///< of the thread that calls write()
  SpscRing<Block, kBlocks> blocks_;
  std::atomic<bool> ended_{false}, finished_{false}, refused_{false};
  std::thread thread_;
};

}  // namespace farrier::sim_bridge
