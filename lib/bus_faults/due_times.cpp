#include "bus_faults/due_times.hpp"

namespace farrier::bus_faults {

DueTimes::DueTimes(std::shared_ptr<bus::Notifier> notifier)
    : notifier_(std::move(notifier)), thread_([this] { run(); }) {}

DueTimes::~DueTimes() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void DueTimes::add(SteadyTime due) {
  {
    const std::lock_guard lock(mutex_);
    times_.push(due);
  }
  changed_.notify_one();
}

void DueTimes::run() {
  std::unique_lock lock(mutex_);
  while (!ends_) {
    if (times_.empty()) {
      changed_.wait(lock);
    } else if (const SteadyTime next = times_.top(); changed_.wait_until(lock, next) == std::cv_status::timeout) {
      while (!times_.empty() && times_.top() <= next) {
        times_.pop();
        notifier_->arrived();
      }
    }
  }
}

}  // namespace farrier::bus_faults
