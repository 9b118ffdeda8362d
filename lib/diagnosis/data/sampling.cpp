#include "diagnosis/data/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "diagnosis/data/time_line.hpp"
#include "diagnosis/judge/finding_text.hpp"

namespace farrier::diagnosis {
namespace {

constexpr double kUneven = 0.02;           // of the median interval
constexpr double kOccasionalShare = 0.01;  // of all intervals
constexpr double kShortestPeriod_s = 20e-6;
constexpr double kLongestPeriod_s = 50e-3;
constexpr double kDecimalRounding = 1e-6;  // of times written in decimals

bool is_period(double period_s) {
  return period_s >= kShortestPeriod_s * (1.0 - kDecimalRounding) &&
         period_s <= kLongestPeriod_s * (1.0 + kDecimalRounding);
}

/// Intervals by kind of defect.
struct Intervals {
  Places backwards, repeated, gaps, uneven;
  std::size_t judged = 0;
  double longest_gap = 0.0;
  double largest_deviation = 0.0;  ///< of the uneven ones, over the median

  Intervals(std::span<const double> time_s, std::span<const std::size_t> line, double median) {
    for (std::size_t i = 1; i < time_s.size(); ++i) {
      const double interval = time_s[i] - time_s[i - 1];
      if (!std::isfinite(interval)) {
        continue;
      }
      ++judged;
      const double deviation = std::abs(interval - median) / median;
      if (interval < 0.0) {
        backwards.add(line[i]);
      } else if (interval == 0.0) {
        repeated.add(line[i]);
      } else if (interval > kGap * median) {
        gaps.add(line[i]);
        longest_gap = std::max(longest_gap, interval);
      } else if (deviation > kUneven) {
        uneven.add(line[i]);
        largest_deviation = std::max(largest_deviation, deviation);
      }
    }
  }
};

void report_intervals(const Intervals& intervals, double median, std::vector<Finding>& findings) {
  const auto add = [&](const char* what, const Places& places, const std::string& sentence) {
    if (places.count() > 0) {
      findings.push_back({what, places.first(), places.text() + ", time: " + sentence});
    }
  };
  add("time_backwards", intervals.backwards,
      "goes back " + counted(intervals.backwards.count(), "time") +
          "; put the rows in the order of their times, or keep one recording of several");
  add("duplicate_time", intervals.repeated,
      counted(intervals.repeated.count(), "row") +
          " with the time of the row before; delete repeated rows, or write the times with more digits");
  add("gap", intervals.gaps,
      counted(intervals.gaps.count(), "gap") + " before, up to " + rounded(intervals.longest_gap) +
          " s where samples are " + rounded(median) +
          " s apart; keep the longest part without one, or record without loss");
  const std::string uneven = counted(intervals.uneven.count(), "interval") + " of " + std::to_string(intervals.judged) +
                             " off the median of " + rounded(median) + " s by up to " +
                             rounded(100.0 * intervals.largest_deviation) + " %; ";
  const double share = static_cast<double>(intervals.uneven.count()) / static_cast<double>(intervals.judged);
  if (share <= kOccasionalShare) {
    add("jitter", intervals.uneven, uneven + "cut the recording there, or interpolate it to even times");
  } else {
    add("uneven_sampling", intervals.uneven,
        uneven + "record with a fixed period and write the times with enough digits, or interpolate to even times");
  }
}

/// Periods no controller has are another unit's.
void report_unit(double median, std::size_t line, std::vector<Finding>& findings) {
  if (median <= 0.0 || is_period(median)) {
    return;
  }
  std::string text = "line " + std::to_string(line) + ", time: samples are " + rounded(median) + " s apart, beyond " +
                     rounded(kShortestPeriod_s) + " to " + rounded(kLongestPeriod_s) + " s; ";
  if (is_period(median / 1e3)) {
    text += "this looks like milliseconds (or a count of samples): divide by 1000";
  } else if (is_period(median / 1e6)) {
    text += "this looks like microseconds: divide by 1000000";
  } else if (is_period(median / 1e9)) {
    text += "this looks like nanoseconds: divide by 1000000000";
  } else {
    text += "give times in s of a recording within these bounds";
  }
  findings.push_back({"wrong_units", line, text});
}

void report_length(std::size_t samples, double median, std::vector<Finding>& findings) {
  const double duration_s = static_cast<double>(samples) * median;
  const bool judged = median > 0.0 && is_period(median);
  if (samples >= kFewestSamples && (!judged || duration_s >= kShortestDuration_s * (1.0 - kUneven / 2.0))) {
    return;
  }
  std::string text = "the file holds " + counted(samples, "sample");
  text += judged ? " over " + rounded(duration_s) + " s" : "";
  findings.push_back({"too_short", 0,
                      text + "; record at least " + counted(kFewestSamples, "sample") + " and " +
                          rounded(kShortestDuration_s) + " s"});
}

}  // namespace

std::vector<Finding> check_times(std::span<const double> time_s, std::span<const std::size_t> line) {
  std::vector<Finding> findings;
  const double median = median_step(time_s);
  if (time_s.size() > 1) {
    const Intervals intervals(time_s, line, median);
    if (intervals.judged > 0) {
      report_intervals(intervals, median, findings);
    }
    report_unit(median, line[0], findings);
  }
  report_length(time_s.size(), median, findings);
  return findings;
}

double period_of(std::span<const double> time_s) {
  return (time_s.back() - time_s.front()) / static_cast<double>(time_s.size() - 1);
}

}  // namespace farrier::diagnosis
