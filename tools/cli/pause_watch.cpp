#include "tools/cli/pause_watch.hpp"

#include <algorithm>

#include "runtime/deadline.hpp"
#include "runtime/realtime_thread.hpp"

namespace farrier::cli {
namespace {

using namespace std::chrono_literals;

constexpr int kAboveAll = runtime::kControlPriority + 10;

}  // namespace

PauseWatch::PauseWatch()
    : thread_([this] {
        static_cast<void>(runtime::set_priority(kAboveAll));
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
