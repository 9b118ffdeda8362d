#include "cli/processes/pause_watch.hpp"

#include <algorithm>

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

void PauseWatch::forget() {
  const std::lock_guard lock(mutex_);
  pauses_.clear();
}

std::vector<Pause> PauseWatch::longer_than(Nanoseconds at_least) const {
  std::vector<Pause> longer;
  const std::lock_guard lock(mutex_);
  std::ranges::copy_if(pauses_, std::back_inserter(longer),
                       [at_least](const Pause& pause) { return pause.end - pause.begin > at_least; });
  return longer;
}

Nanoseconds PauseWatch::longest() const {
  Nanoseconds longest{0};
  const std::lock_guard lock(mutex_);
  for (const Pause& pause : pauses_) {
    longest = std::max<Nanoseconds>(longest, pause.end - pause.begin);
  }
  return longest;
}

void PauseWatch::watch(int processor, int priority) {
  runtime::stay_on(processor);
  static_cast<void>(runtime::set_priority(priority));
  while (!ends_) {
    const SteadyTime due = std::chrono::steady_clock::now() + 1ms;
    runtime::sleep_until(due);
    const SteadyTime awake = std::chrono::steady_clock::now();
    if (awake - due > 1ms) {
      const std::lock_guard lock(mutex_);
      pauses_.push_back({due, awake});
    }
  }
}

}  // namespace farrier::cli
