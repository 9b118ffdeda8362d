#include "tools/cli/pause_watch.hpp"

#include "runtime/deadline.hpp"
#include "runtime/processors.hpp"

namespace farrier::cli {

using namespace std::chrono_literals;

PauseWatch::PauseWatch(int priority) {
  for (const int processor : runtime::own_processors()) {
    threads_.emplace_back([this, processor, priority] { watch(processor, priority); });
  }
}

PauseWatch::~PauseWatch() {
  ends_ = true;
  for (std::thread& thread : threads_) {
    thread.join();
  }
}

void PauseWatch::watch(int processor, int priority) noexcept {
  runtime::stay_on(processor);
  static_cast<void>(runtime::set_priority(priority));
  while (!ends_) {
    const SteadyTime due = std::chrono::steady_clock::now() + 1ms;
    runtime::sleep_until(due);
    const std::int64_t late = Nanoseconds(std::chrono::steady_clock::now() - due).count();
    std::int64_t longest = longest_ns_.load();
    while (late > longest && !longest_ns_.compare_exchange_weak(longest, late)) {
    }
  }
}

}  // namespace farrier::cli
