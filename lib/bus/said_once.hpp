#pragma once

#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace farrier::bus {

/// Messages from a bus to its process, added by any thread of the bus. Each sentence is kept once. Their number is
/// limited, so that repeated attempts to join cannot fill the memory.
class SaidOnce {
 public:
  void add(const std::string& sentence) {
    const std::lock_guard lock(mutex_);
    if (said_.size() < kMost && said_.insert(sentence).second) {
      waiting_.push_back(sentence);
    }
  }
  /// Those that came since the last call.
  std::vector<std::string> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(waiting_, {});
  }

 private:
  static constexpr std::size_t kMost = 64;

  std::mutex mutex_;
  std::set<std::string> said_;
  std::vector<std::string> waiting_;
};

}  // namespace farrier::bus
