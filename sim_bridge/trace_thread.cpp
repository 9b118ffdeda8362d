#include "sim_bridge/trace_thread.hpp"

#include <chrono>
#include <string_view>
#include <utility>

#include "runtime/realtime_thread.hpp"

namespace farrier::sim_bridge {

using namespace std::chrono_literals;

TraceThread::TraceThread(trace::TraceWriter writer) : writer_(std::move(writer)), thread_([this] { run(); }) {}

TraceThread::~TraceThread() {
  end();
  thread_.join();
}

void TraceThread::write(const trace::TraceRow& row) noexcept {
  char* const line = filling_.lines.data() + filling_.size;
  filling_.size += static_cast<std::size_t>(writer_.format(row, line) - line);
  if (filling_.size + trace::TraceWriter::kLongestLine > filling_.lines.size()) {
    hand_over();
  }
}

void TraceThread::hand_over() noexcept {
  static_cast<void>(blocks_.push(filling_));
  filling_.size = 0;
}

void TraceThread::end() noexcept {
  if (filling_.size > 0) {
    hand_over();
  }
  ended_.store(true, std::memory_order_release);
}

void TraceThread::run() {
  runtime::name_thread("trace");
  runtime::set_no_priority();
  for (bool ended = false; !ended;) {
    ended = ended_.load(std::memory_order_acquire);
    for (Block block; blocks_.pop(block);) {
      writer_.write_lines(std::string_view(block.lines.data(), block.size));
    }
    if (!ended) {
      std::this_thread::sleep_for(5ms);
    }
  }
  refused_.store(!writer_.finish(), std::memory_order_relaxed);
  finished_.store(true, std::memory_order_release);
}

}  // namespace farrier::sim_bridge
