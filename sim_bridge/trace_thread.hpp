#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

#include "core/spsc_ring.hpp"
#include "runtime/realtime_thread.hpp"
#include "sim_bridge/traces.hpp"

namespace farrier::sim_bridge {

/// Writes a trace to the disk on a thread of its own, without priority: a slow disk blocks nothing else. `Writer` is
/// trace::TraceWriter, trace::BodyTraceWriter or trace::SupplyTraceWriter.
template <class Writer>
class TraceThread {
 public:
  explicit TraceThread(Writer writer) : writer_(std::move(writer)), thread_([this] { run(); }) {}
  /// Writes all rows that have come.
  ~TraceThread() {
    end();
    thread_.join();
  }
  TraceThread(const TraceThread&) = delete;
  TraceThread& operator=(const TraceThread&) = delete;

  /// For one thread only. Rows are lost if the disk is behind by kBlocks: a second and a half of twelve joints at 1
  /// kHz.
  template <class Row>
  void write(const Row& row) noexcept {
    char* const line = filling_.lines.data() + filling_.size;
    filling_.size += static_cast<std::size_t>(writer_.format(row, line) - line);
    if (filling_.size + Writer::kLongestLine > filling_.lines.size()) {
      hand_over();
    }
  }
  /// Call on the same thread: no more rows come.
  void end() noexcept {
    if (filling_.size > 0) {
      hand_over();
    }
    ended_.store(true, std::memory_order_release);
  }

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

  void hand_over() noexcept {
    static_cast<void>(blocks_.push(filling_));
    filling_.size = 0;
  }

  void run() {
    runtime::name_thread("trace");
    runtime::set_no_priority();
    for (bool ended = false; !ended;) {
      ended = ended_.load(std::memory_order_acquire);
      for (Block block; blocks_.pop(block);) {
        writer_.write_lines(std::string_view(block.lines.data(), block.size));
      }
      if (!ended) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      }
    }
    refused_.store(!writer_.finish(), std::memory_order_relaxed);
    finished_.store(true, std::memory_order_release);
  }

  Writer writer_;
  Block filling_;  ///< of the thread that calls write()
  SpscRing<Block, kBlocks> blocks_;
  std::atomic<bool> ended_{false}, finished_{false}, refused_{false};
  std::thread thread_;
};

/// The files of a run's trace, a thread each.
class TraceThreads {
 public:
  explicit TraceThreads(Traces traces) {
    if (traces.joints) {
      joints.emplace(std::move(*traces.joints));
    }
    if (traces.body) {
      body.emplace(std::move(*traces.body));
    }
    if (traces.supply) {
      supply.emplace(std::move(*traces.supply));
    }
  }

  std::optional<TraceThread<trace::TraceWriter>> joints;
  std::optional<TraceThread<trace::BodyTraceWriter>> body;
  std::optional<TraceThread<trace::SupplyTraceWriter>> supply;

  /// As end(), finished() and complete() of each.
  void end() noexcept {
    visit([](auto& trace) { trace.end(); });
  }
  bool finished() const noexcept {
    bool all = true;
    visit([&](const auto& trace) { all = all && trace.finished(); });
    return all;
  }
  bool complete() const noexcept {
    bool all = true;
    visit([&](const auto& trace) { all = all && trace.complete(); });
    return all;
  }

 private:
  template <class Act>
  void visit(Act&& act) {
    joints ? act(*joints) : void();
    body ? act(*body) : void();
    supply ? act(*supply) : void();
  }
  template <class Act>
  void visit(Act&& act) const {
    joints ? act(*joints) : void();
    body ? act(*body) : void();
    supply ? act(*supply) : void();
  }
};

}  // namespace farrier::sim_bridge
