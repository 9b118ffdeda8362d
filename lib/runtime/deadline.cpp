#include "runtime/deadline.hpp"

#include <ctime>

namespace farrier::runtime {

Deadline next_deadline(SteadyTime previous, SteadyTime now, Nanoseconds period) noexcept {
  const SteadyTime due = previous + period;
  if (now < due) {
    return {due, 0};
  }
  const auto skipped = (now - due) / period + 1;
  return {due + skipped * period, static_cast<std::uint64_t>(skipped)};
}

void sleep_until(SteadyTime time) noexcept {
  const auto since_epoch = std::chrono::duration_cast<Nanoseconds>(time.time_since_epoch()).count();
  timespec wake{};
  wake.tv_sec = since_epoch / 1'000'000'000;
  wake.tv_nsec = since_epoch % 1'000'000'000;
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr) != 0) {
  }
}

}  // namespace farrier::runtime
