#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>

#include "runtime/awake_processors.hpp"

namespace farrier::runtime {
namespace awake_test {

/// The bound of wake-up latency that the kernel keeps now, microseconds; -1 where it cannot be asked.
std::int32_t bound_us() {
  const int file = ::open("/dev/cpu_dma_latency", O_RDONLY | O_CLOEXEC);
  std::int32_t bound = -1;
  if (file >= 0 && ::read(file, &bound, sizeof bound) != sizeof bound) {
    bound = -1;
  }
  ::close(file);
  return bound;
}

TEST(AwakeProcessors, HoldTheKernelToNoLatencyWhileTheyAreWanted) {
  if (bound_us() < 0) {
    GTEST_SKIP() << "/dev/cpu_dma_latency cannot be opened: needs root, and a kernel with cpuidle";
  }
  const AwakeProcessors awake;
  EXPECT_EQ(awake.lacking(), "");
  EXPECT_EQ(bound_us(), 0);
}

}  // namespace awake_test
}  // namespace farrier::runtime
