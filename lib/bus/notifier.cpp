#include "bus/notifier.hpp"

namespace farrier::bus {

void Notifier::arrived() noexcept {
  bool reached = false;
  {
    const std::lock_guard lock(mutex_);
    ++arrivals_;
    reached = arrivals_ >= target_;
  }
  if (reached) {
    reached_.notify_one();
  }
}

void Notifier::wake() noexcept {
  {
    const std::lock_guard lock(mutex_);
    woken_ = true;
  }
  reached_.notify_one();
}

std::uint64_t Notifier::arrivals() const noexcept {
  const std::lock_guard lock(mutex_);
  return arrivals_;
}

void Notifier::wait_for_arrivals(std::uint64_t target, std::chrono::nanoseconds timeout) noexcept {
  std::unique_lock lock(mutex_);
  target_ = target;
  reached_.wait_for(lock, timeout, [this] { return woken_ || arrivals_ >= target_; });
  target_ = UINT64_MAX;
  woken_ = false;
}

}  // namespace farrier::bus
