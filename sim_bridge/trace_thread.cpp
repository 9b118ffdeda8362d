#include "sim_bridge/trace_thread.hpp"

#include <chrono>
#include <utility>

#include "runtime/realtime_thread.hpp"

namespace farrier::sim_bridge {

using namespace std::chrono_literals;

constexpr auto kLooks = 100ms;  // when nobody tells it to

TraceThread::TraceThread(record::TraceWriter writer) : writer_(std::move(writer)), thread_([this] { run(); }) {}

TraceThread::~TraceThread() {
  end();
  thread_.join();
}

void TraceThread::run() {
  runtime::name_thread("trace");
  runtime::set_no_priority();
  for (bool ended = false; !ended;) {
    ended = ended_.load(std::memory_order_acquire);
    for (record::TraceRow row; rows_.pop(row);) {
      writer_.write(row);
    }
    if (!ended) {
      looks_.wait_until(std::chrono::steady_clock::now() + kLooks);
    }
  }
  refused_.store(!writer_.finish(), std::memory_order_relaxed);
  finished_.store(true, std::memory_order_release);
}

}  // namespace farrier::sim_bridge
