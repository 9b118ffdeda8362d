#include "runtime/awake_processors.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

namespace farrier::runtime {

AwakeProcessors::AwakeProcessors() noexcept : file_(::open("/dev/cpu_dma_latency", O_WRONLY | O_CLOEXEC)) {
  constexpr std::int32_t kLatency_us = 0;
  if (file_ < 0 || ::write(file_, &kLatency_us, sizeof kLatency_us) != sizeof kLatency_us) {
    error_ = errno;
  }
}

AwakeProcessors::~AwakeProcessors() {
  if (file_ >= 0) {
    ::close(file_);
  }
}

std::string AwakeProcessors::lacking() const {
  return error_ == 0 || error_ == ENOENT ? std::string()
                                         : std::string("processors that stay awake (") + std::strerror(error_) + ")";
}

}  // namespace farrier::runtime
