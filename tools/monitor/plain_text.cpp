#include "tools/monitor/plain_text.hpp"

#include <cstdio>

#include "participant/clock.hpp"
#include "tools/monitor/terminal_table.hpp"

namespace farrier::display {

using namespace std::chrono_literals;

bool print_table(const monitor::Frame& frame, const robot::Robot& robot, std::span<const monitor::EventFrame> events) {
  std::fputs(text_of(terminal_table(frame, robot, events, {})).c_str(), stdout);
  return std::fflush(stdout) == 0;
}

void PlainText::show(const monitor::Frame& frame) {
  events_.take(frame);
  const SteadyTime now = participant::steady_now();
  if (now < next_) {
    return;
  }
  next_ = now + 1s;
  ended_ = !print_table(frame, robot_, events_.all()) || std::fputs("\n", stdout) < 0;
}

}  // namespace farrier::display
