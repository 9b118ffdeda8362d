#include "runtime/realtime_thread.hpp"

#include <sched.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstring>

namespace farrier::runtime {
namespace {

void touch_stack() noexcept {
  constexpr std::size_t kStack = 256 * 1024;
  constexpr std::size_t kPage = 4096;
  volatile char pages[kStack];
  for (std::size_t i = 0; i < kStack; i += kPage) {
    pages[i] = 0;
  }
}

}  // namespace

std::string make_realtime(int priority) {
  std::string lacking;
  sched_param parameters{};
  parameters.sched_priority = priority;
  if (sched_setscheduler(0, SCHED_FIFO, &parameters) != 0) {
    lacking = std::string("real-time priority (") + std::strerror(errno) + ")";
  }
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
    lacking += std::string(lacking.empty() ? "" : ", ") + "locked memory (" + std::strerror(errno) + ")";
  }
  touch_stack();
  return lacking;
}

}  // namespace farrier::runtime
