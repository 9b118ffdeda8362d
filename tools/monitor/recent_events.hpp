#pragma once

#include <span>
#include <vector>

#include "monitor/frame.hpp"

namespace farrier::display {

/// The newest events of the frames so far, in the order in which they came.
class RecentEvents {
 public:
  void take(const monitor::Frame& frame) {
    events_.insert(events_.end(), frame.events.begin(), frame.events.end());
    if (events_.size() > 2 * kKept) {
      events_.erase(events_.begin(), events_.end() - kKept);
    }
  }
  std::span<const monitor::EventFrame> all() const noexcept { return events_; }

 private:
  static constexpr std::size_t kKept = 100;  // more than a terminal has lines

  std::vector<monitor::EventFrame> events_;
};

}  // namespace farrier::display
