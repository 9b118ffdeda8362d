#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace farrier::recording {

/// A place at which log times do not go on as samples do: a clock of day that was set, or a long pause.
struct ClockStep {
  std::uint64_t at_ns = 0;               ///< elapsed time of the sample behind it
  std::uint64_t from_ns = 0, to_ns = 0;  ///< log times before and behind it

  /// Seconds by which the clock went on, negative for one that went back.
  double by_s() const noexcept;
};

/// "at 12.5 s the clock of day goes from 1970-01-01T00:02:05Z to 2026-11-29T20:30:00Z, by 1.796e+09 s"
std::string to_string(const ClockStep& step);

/// Turns log times into time since the first sample, without the steps of the clock.
class Timeline {
 public:
  /// A robot that runs says something every second; a longer silence is a step.
  static constexpr std::uint64_t kLongestGap_ns = 10'000'000'000;
  /// A channel whose own log time goes back by more than this is a step.
  static constexpr std::uint64_t kLargestDisorder_ns = 10'000'000'000;
  /// A channel may lie behind others by so much: a recorder that lags writes the channels one after another.
  static constexpr std::uint64_t kLongestLag_ns = 60'000'000'000;
  /// Steps that are kept. All are counted.
  static constexpr std::size_t kMostSteps = 20;

  /// Time in ns since the first sample of one of this channel with this log time. Calls are in the file's order.
  std::uint64_t elapsed_ns(std::uint16_t channel, std::uint64_t log_time_ns);

  const std::vector<ClockStep>& steps() const noexcept { return steps_; }
  std::uint64_t step_count() const noexcept { return step_count_; }

 private:
  bool begun_ = false;
  std::uint64_t newest_ns_ = 0;                          // log time
  std::map<std::uint16_t, std::uint64_t> newest_of_ns_;  // by channel, since the last step
  std::uint64_t elapsed_ns_ = 0;                         // at newest_ns_
  std::vector<ClockStep> steps_;
  std::uint64_t step_count_ = 0;
};

/// A sentence part per step, and one for those beyond kMostSteps. Empty without a step.
std::vector<std::string> step_texts(const Timeline& timeline);

}  // namespace farrier::recording
