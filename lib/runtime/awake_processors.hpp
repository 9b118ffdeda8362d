#pragma once

#include <string>

namespace farrier::runtime {

/// While it lives the idle processors of this computer do not sleep. A sleeping processor is woken in tens of
/// microseconds, one of a virtual machine when its host has time for it. Costs power. Linux, "PM Quality Of Service
/// Interface": the bound of wake-up latency in /dev/cpu_dma_latency, here 0, holds while the file is open.
class AwakeProcessors {
 public:
  AwakeProcessors() noexcept;
  ~AwakeProcessors();
  AwakeProcessors(const AwakeProcessors&) = delete;
  AwakeProcessors& operator=(const AwakeProcessors&) = delete;

  /// Returns what was refused. Empty if nothing was, and if there is no such file. In the latter case the kernel has
  /// none, or a systemd unit hides it; `farrier deploy render` then also writes a unit that keeps processors out of
  /// idle states.
  std::string lacking() const;

 private:
  int file_;
  int error_ = 0;
};

}  // namespace farrier::runtime
