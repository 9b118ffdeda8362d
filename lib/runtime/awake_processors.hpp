#pragma once

#include <string>

namespace farrier::runtime {

/// While it lives the processors of this computer do not sleep when they have nothing to do: a sleeping one is woken in
/// tens of microseconds, one of a virtual machine when its host has time for it. Costs power. Linux, "PM Quality Of
/// Service Interface": the bound of wake-up latency in /dev/cpu_dma_latency, here 0, holds while the file is open.
class AwakeProcessors {
 public:
  AwakeProcessors() noexcept;
  ~AwakeProcessors();
  AwakeProcessors(const AwakeProcessors&) = delete;
  AwakeProcessors& operator=(const AwakeProcessors&) = delete;

  /// What could not be had; empty when it could, and where there is no such file: the kernel has none, or a unit of
  /// systemd hides it, beside which `farrier deploy render` writes one that keeps processors awake.
  std::string lacking() const;

 private:
  int file_;
  int error_ = 0;
};

}  // namespace farrier::runtime
