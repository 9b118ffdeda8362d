#include "sim_bridge/trace_thread.hpp"

#include <chrono>
#include <utility>

#include "runtime/realtime_thread.hpp"

namespace farrier::sim_bridge {

using namespace std::chrono_literals;

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
      std::this_thread::sleep_for(5ms);
    }
  }
  refused_.store(!writer_.finish(), std::memory_order_relaxed);
  finished_.store(true, std::memory_order_release);
}

}  // namespace farrier::sim_bridge
