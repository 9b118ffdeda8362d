#include "tools/cli/pause_watch.hpp"

#include <algorithm>

#include "runtime/deadline.hpp"

namespace farrier::cli {
namespace {

using namespace std::chrono_literals;

}  // namespace

PauseWatch::PauseWatch(int priority)
    : thread_([this, priority] {
        static_cast<void>(runtime::set_priority(priority));
        while (!ends_) {
          const SteadyTime due = std::chrono::steady_clock::now() + 1ms;
          runtime::sleep_until(due);
          const std::int64_t late = Nanoseconds(std::chrono::steady_clock::now() - due).count();
          longest_ns_ = std::max(longest_ns_.load(), late);
        }
      }) {}

PauseWatch::~PauseWatch() {
  ends_ = true;
  thread_.join();
}

}  // namespace farrier::cli
