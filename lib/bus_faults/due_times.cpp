#include "bus_faults/due_times.hpp"

namespace farrier::bus_faults {

DueTimes::DueTimes(std::shared_ptr<bus::Notifier> notifier, Clock clock)
    : notifier_(std::move(notifier)), clock_(std::move(clock)), thread_([this] { run(); }) {}

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
    } else if (const Nanoseconds left = times_.top() - clock_.now(); left > Nanoseconds(0)) {
      changed_.wait_for(lock, left * clock_.slow);
    } else {
      times_.pop();
      notifier_->arrived();
    }
  }
}

}  // namespace farrier::bus_faults
