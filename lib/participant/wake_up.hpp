#pragma once

#include <semaphore.h>

#include <ctime>

#include "core/time.hpp"

namespace farrier::participant {

/// Lets one thread wake another without a lock (POSIX semaphore): post() never blocks.
class WakeUp {
 public:
  WakeUp() { sem_init(&semaphore_, 0, 0); }
  ~WakeUp() { sem_destroy(&semaphore_); }
  WakeUp(const WakeUp&) = delete;
  WakeUp& operator=(const WakeUp&) = delete;

  void post() noexcept { sem_post(&semaphore_); }

  /// True if a wait would return at once.
  bool posted() noexcept {
    int posts = 0;
    sem_getvalue(&semaphore_, &posts);
    return posts > 0;
  }

  /// True when posted, false at the deadline, which is the machine's time. Several posts wake once.
  bool wait_until(SteadyTime deadline) noexcept {
    const auto since_epoch = std::chrono::duration_cast<Nanoseconds>(deadline.time_since_epoch()).count();
    timespec until{};
    until.tv_sec = since_epoch / 1'000'000'000;
    until.tv_nsec = since_epoch % 1'000'000'000;
    if (sem_clockwait(&semaphore_, CLOCK_MONOTONIC, &until) != 0) {
      return false;
    }
    while (sem_trywait(&semaphore_) == 0) {
    }
    return true;
  }

 private:
  sem_t semaphore_;
};

}  // namespace farrier::participant
