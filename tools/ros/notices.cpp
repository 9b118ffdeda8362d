#include "tools/ros/notices.hpp"

#include <cstdio>
#include <utility>

namespace farrier::ros_bridge {

void Notices::tell(signals::Severity severity, const std::string& text, const Time& stamp, SteadyTime now) {
  using namespace std::chrono_literals;
  constexpr Nanoseconds kOften = 5s;
  std::erase_if(told_, [&](const auto& line) { return now - line.second >= kOften; });
  if (text.empty() || told_.size() >= kMost || !told_.try_emplace(text, now).second) {
    return;
  }
  std::fprintf(stderr, "farrier ros: %s\n", text.c_str());
  monitor::EventFrame event;
  event.severity = severity;
  event.who = "bridge";
  event.text = text;
  write(event, stamp);
}

void Notices::write(const monitor::EventFrame& event, const Time& stamp) {
  log_.write(ros_view::log_line(event, node_, stamp));
}

void NoticeQueue::put(signals::Severity severity, std::string text) {
  constexpr std::size_t kMost = 64;
  const std::scoped_lock lock(mutex_);
  if (waiting_.size() < kMost && (waiting_.empty() || waiting_.back().text != text)) {
    waiting_.push_back({severity, std::move(text)});
  }
}

std::deque<NoticeQueue::Notice> NoticeQueue::take() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(waiting_, {});
}

}  // namespace farrier::ros_bridge
