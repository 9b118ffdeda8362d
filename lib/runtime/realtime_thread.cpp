#include "runtime/realtime_thread.hpp"

#include <dirent.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
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

void set_no_priority() noexcept {
  const sched_param parameters{};
  sched_setscheduler(0, SCHED_OTHER, &parameters);
}

void give_way() noexcept {
  constexpr int kNicest = 19;
  static_cast<void>(setpriority(PRIO_PROCESS, static_cast<id_t>(thread_id()), kNicest));
}

void raise_threads(int from, int to) noexcept {
  DIR* const threads = opendir("/proc/self/task");
  if (threads == nullptr) {
    return;
  }
  while (const dirent* entry = readdir(threads)) {
    const pid_t thread = std::atoi(entry->d_name);
    sched_param parameters{};
    if (thread > 0 && sched_getscheduler(thread) == SCHED_FIFO && sched_getparam(thread, &parameters) == 0 &&
        parameters.sched_priority == from) {
      set_priority_of(thread, to);
    }
  }
  closedir(threads);
}

void use_small_stacks() noexcept {
  constexpr std::size_t kStack = 2 << 20;
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, kStack);
  pthread_setattr_default_np(&attributes);
  pthread_attr_destroy(&attributes);
}

std::string lock_memory() {
  touch_stack();
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
    return std::string("locked memory (") + std::strerror(errno) + ")";
  }
  return {};
}

}  // namespace farrier::runtime
