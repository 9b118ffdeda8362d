#include "participant/clock.hpp"

#include <atomic>

namespace farrier::participant {
namespace {

std::atomic<int> slow_factor{1};

}  // namespace

void set_slow_motion(int slow) noexcept { slow_factor = slow; }

int slow_motion() noexcept { return slow_factor; }

SteadyTime steady_now() noexcept {
  return SteadyTime(std::chrono::steady_clock::now().time_since_epoch() / slow_motion());
}

std::time_t date_now() noexcept {
  return std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
}

std::uint64_t date_now_ns() noexcept {
  return static_cast<std::uint64_t>(Nanoseconds(std::chrono::system_clock::now().time_since_epoch()).count());
}

SteadyTime machine_time(SteadyTime time) noexcept { return SteadyTime(time.time_since_epoch() * slow_motion()); }

}  // namespace farrier::participant
