#include "bus_cyclone/cyclone_waits.hpp"

#include <dds/dds.h>
#include <dds/ddsrt/sync.h>
#include <dds/ddsrt/time.h>
#include <pthread.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <ctime>

// Cyclone 0.10 waits until a time of the wall clock (issue 1995 of eclipse-cyclonedds/cyclonedds). If that clock is set
// back an hour, its threads block for an hour, and the other processes drop this one after a lease. The library libddsc
// calls these two functions by its procedure linkage table, so they replace its own.
extern "C" {

bool ddsrt_cond_waitfor(ddsrt_cond_t* condition, ddsrt_mutex_t* mutex, dds_duration_t how_long) {
  const std::int64_t now_ns = ddsrt_time_monotonic().v;
  if (how_long >= DDS_INFINITY - now_ns) {
    ddsrt_cond_wait(condition, mutex);
    return true;
  }
  const std::int64_t until_ns = now_ns + std::max<dds_duration_t>(how_long, 0);
  const timespec until{until_ns / DDS_NSECS_IN_SEC, until_ns % DDS_NSECS_IN_SEC};
  const int status = ::pthread_cond_clockwait(&condition->cond, &mutex->mutex, CLOCK_MONOTONIC, &until);
  if (status != 0 && status != ETIMEDOUT) {
    std::abort();
  }
  return status == 0;
}

bool ddsrt_cond_waituntil(ddsrt_cond_t* condition, ddsrt_mutex_t* mutex, dds_time_t wall_clock) {
  return ddsrt_cond_waitfor(condition, mutex, wall_clock == DDS_NEVER ? DDS_INFINITY : wall_clock - dds_time());
}

}  // extern "C"

namespace farrier::bus_cyclone {

void wait_on_steady_clock() noexcept {}

}  // namespace farrier::bus_cyclone
