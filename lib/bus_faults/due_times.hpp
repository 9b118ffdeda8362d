#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <queue>
#include <thread>
#include <vector>

#include "bus/notifier.hpp"
#include "core/time.hpp"

namespace farrier::bus_faults {

using Clock = std::function<SteadyTime()>;

/// Tells a bus's sleeper of samples that were held back, when they are due. Any thread may add.
class DueTimes {
 public:
  explicit DueTimes(std::shared_ptr<bus::Notifier> notifier);
  ~DueTimes();
  DueTimes(const DueTimes&) = delete;
  DueTimes& operator=(const DueTimes&) = delete;

  void add(SteadyTime due);

 private:
  void run();

  std::shared_ptr<bus::Notifier> notifier_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::priority_queue<SteadyTime, std::vector<SteadyTime>, std::greater<>> times_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace farrier::bus_faults
