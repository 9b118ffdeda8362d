#include "diagnosis/judge/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>
#include <vector>

namespace farrier::diagnosis {

ForEach by_threads(int threads, const std::function<void(double)>& progress, std::size_t rounds) {
  return [threads, progress, rounds, done = std::make_shared<std::atomic<std::size_t>>(0)](
             std::size_t count, const std::function<void(std::size_t)>& piece) {
    std::atomic<std::size_t> next{0};
    const auto work = [&](bool tells) {
      for (std::size_t i = next++; i < count; i = next++) {
        piece(i);
        const std::size_t all = ++*done;
        if (tells) {
          progress(std::min(0.95, static_cast<double>(all) / static_cast<double>(rounds * count)));
        }
      }
    };
    std::vector<std::jthread> others;
    for (int i = 1; i < threads; ++i) {
      others.emplace_back(work, false);
    }
    work(true);
  };
}

}  // namespace farrier::diagnosis
