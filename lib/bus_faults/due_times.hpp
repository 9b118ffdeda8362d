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

/// The clock that times of samples are by, which may be slower than the machine's.
struct Clock {
  std::function<SteadyTime()> now;
  int slow = 1;
};

/// Tells a bus's sleeper of samples that were held back, when they are due. Any thread may add.
class DueTimes {
 public:
  DueTimes(std::shared_ptr<bus::Notifier> notifier, Clock clock);
  ~DueTimes();
  DueTimes(const DueTimes&) = delete;
  DueTimes& operator=(const DueTimes&) = delete;

  void add(SteadyTime due);

 private:
  void run();

  std::shared_ptr<bus::Notifier> notifier_;
  Clock clock_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::priority_queue<SteadyTime, std::vector<SteadyTime>, std::greater<>> times_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace farrier::bus_faults
