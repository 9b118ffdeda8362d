#include "recording/timeline.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>

namespace farrier::recording {
namespace {

constexpr std::uint64_t kSecond_ns = 1'000'000'000;

std::string date_of(std::uint64_t time_ns) {
  const auto seconds = static_cast<std::time_t>(time_ns / kSecond_ns);
  std::tm date{};
  char text[40];
  if (gmtime_r(&seconds, &date) == nullptr || std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &date) == 0) {
    return std::to_string(time_ns) + " ns";
  }
  return text;
}

}  // namespace

double ClockStep::by_s() const noexcept {
  return to_ns >= from_ns ? static_cast<double>(to_ns - from_ns) * 1e-9 : -static_cast<double>(from_ns - to_ns) * 1e-9;
}

std::string to_string(const ClockStep& step) {
  char at[40], by[40];
  std::snprintf(at, sizeof at, "%.3f", static_cast<double>(step.at_ns) * 1e-9);
  std::snprintf(by, sizeof by, "%+.4g", step.by_s());
  return "at " + std::string(at) + " s the clock of day goes from " + date_of(step.from_ns) + " to " +
         date_of(step.to_ns) + ", by " + by + " s";
}

std::uint64_t Timeline::elapsed_ns(std::uint16_t channel, std::uint64_t log_time_ns) {
  if (!begun_) {
    begun_ = true;
    newest_ns_ = log_time_ns;
  }
  std::uint64_t& newest_of_ns = newest_of_ns_.try_emplace(channel, log_time_ns).first->second;
  const std::uint64_t on_by_ns = log_time_ns > newest_ns_ ? log_time_ns - newest_ns_ : 0;
  const std::uint64_t lag_ns = log_time_ns < newest_ns_ ? newest_ns_ - log_time_ns : 0;
  const std::uint64_t back_by_ns = log_time_ns < newest_of_ns ? newest_of_ns - log_time_ns : 0;
  newest_of_ns = std::max(newest_of_ns, log_time_ns);
  if (on_by_ns > kLongestGap_ns || back_by_ns > kLargestDisorder_ns || lag_ns > kLongestLag_ns) {
    ++step_count_;
    if (steps_.size() < kMostSteps) {
      steps_.push_back({elapsed_ns_, newest_ns_, log_time_ns});
    }
    newest_ns_ = log_time_ns;
    newest_of_ns_ = {{channel, log_time_ns}};
    return elapsed_ns_;
  }
  elapsed_ns_ += on_by_ns;
  newest_ns_ = std::max(newest_ns_, log_time_ns);
  return elapsed_ns_ - std::min(elapsed_ns_, lag_ns);
}

std::vector<std::string> step_texts(const Timeline& timeline) {
  std::vector<std::string> texts;
  for (const ClockStep& step : timeline.steps()) {
    texts.push_back(to_string(step));
  }
  if (timeline.step_count() > texts.size()) {
    texts.push_back(std::to_string(timeline.step_count() - texts.size()) + " further steps of the clock");
  }
  return texts;
}

}  // namespace farrier::recording
