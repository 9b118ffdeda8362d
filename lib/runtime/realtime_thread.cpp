#include "runtime/realtime_thread.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace farrier::runtime {
namespace {

void touch_stack() noexcept {
  constexpr std::size_t kStack = 256 * 1024;
  constexpr std::size_t kPage = 4096;
  char pages[kStack];
  for (std::size_t i = 0; i < kStack; i += kPage) {
    static_cast<volatile char*>(pages)[i] = 0;
  }
}

}  // namespace

void name_thread(const char* name) noexcept { pthread_setname_np(pthread_self(), name); }

pid_t thread_id() noexcept { return gettid(); }

bool set_priority_of(pid_t thread, int priority) noexcept {
  sched_param parameters{};
  parameters.sched_priority = priority;
  return sched_setscheduler(thread, SCHED_FIFO, &parameters) == 0;
}

std::string set_priority(int priority) {
  return set_priority_of(thread_id(), priority)
             ? std::string()
             : std::string("real-time priority (") + std::strerror(errno) + ")";
}

std::string lock_memory() {
  touch_stack();
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
    return std::string("locked memory (") + std::strerror(errno) + ")";
  }
  return {};
}

}  // namespace farrier::runtime
