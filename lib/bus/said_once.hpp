#pragma once

#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace farrier::bus {

/// What a bus has to say to its process while that runs, from any of its threads: each sentence once, and only so many,
/// that nobody fills the memory by knocking.
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
