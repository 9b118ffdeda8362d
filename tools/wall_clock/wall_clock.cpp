// Preloaded into processes whose computer's wall clock is to be set while they run: theirs is the real one plus an offset
// that stands in a file they share (FARRIER_WALL_CLOCK, 8 bytes: nanoseconds). As where a kernel's clock is set, the
// steady clock goes on, and waits that are told a wall-clock time end when this clock shows it.
//
// Not faketime: it blocks clock_nanosleep on the steady clock, and with that every loop in real time.

#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <ctime>

namespace {

using Offset = std::atomic<std::int64_t>;
static_assert(sizeof(Offset) == sizeof(std::int64_t) && Offset::is_always_lock_free);

constexpr std::int64_t kSecond_ns = 1'000'000'000;
/// Longest time until a wait sees that the clock was set.
constexpr std::int64_t kSlice_ns = 5'000'000;

std::int64_t offset_ns() {
  static const Offset* const shared = []() -> const Offset* {
    const char* path = std::getenv("FARRIER_WALL_CLOCK");
    const int file = path != nullptr ? ::open(path, O_RDONLY | O_CLOEXEC) : -1;
    void* const mapped = file >= 0 ? ::mmap(nullptr, sizeof(Offset), PROT_READ, MAP_SHARED, file, 0) : MAP_FAILED;
    if (file >= 0) {
      ::close(file);
    }
    return mapped != MAP_FAILED ? static_cast<const Offset*>(mapped) : nullptr;
  }();
  return shared != nullptr ? shared->load(std::memory_order_relaxed) : 0;
}

int real_clock_gettime(clockid_t clock, timespec* time) {
  static const auto real = reinterpret_cast<int (*)(clockid_t, timespec*)>(::dlsym(RTLD_NEXT, "clock_gettime"));
  return real(clock, time);
}

std::int64_t nanoseconds(const timespec& time) { return time.tv_sec * kSecond_ns + time.tv_nsec; }
timespec time_of(std::int64_t ns) { return {ns / kSecond_ns, ns % kSecond_ns}; }

std::int64_t now_ns(clockid_t clock) {
  timespec time{};
  real_clock_gettime(clock, &time);
  return nanoseconds(time);
}

std::int64_t wall_ns() { return now_ns(CLOCK_REALTIME) + offset_ns(); }

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* time) noexcept {
  const int status = real_clock_gettime(clock, time);
  if (status == 0 && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE)) {
    *time = time_of(nanoseconds(*time) + offset_ns());
  }
  return status;
}

int gettimeofday(timeval* __restrict time, void* __restrict) noexcept {
  const std::int64_t ns = wall_ns();
  time->tv_sec = ns / kSecond_ns;
  time->tv_usec = ns % kSecond_ns / 1000;
  return 0;
}

std::time_t time(std::time_t* out) noexcept {
  const std::time_t seconds = wall_ns() / kSecond_ns;
  if (out != nullptr) {
    *out = seconds;
  }
  return seconds;
}

int pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex, const timespec* until) {
  const std::int64_t until_ns = nanoseconds(*until);
  for (;;) {
    const std::int64_t left_ns = until_ns - wall_ns();
    const timespec slice = time_of(now_ns(CLOCK_MONOTONIC) + std::clamp(left_ns, std::int64_t{0}, kSlice_ns));
    const int status = ::pthread_cond_clockwait(condition, mutex, CLOCK_MONOTONIC, &slice);
    if (status != ETIMEDOUT || wall_ns() >= until_ns) {
      return status;
    }
  }
}

}  // extern "C"
