#include "diagnosis/data/even_times.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "diagnosis/data/derive_velocity.hpp"
#include "diagnosis/data/even_grid.hpp"
#include "diagnosis/data/sampling.hpp"
#include "diagnosis/data/time_line.hpp"
#include "diagnosis/data/timed_rows.hpp"
#include "diagnosis/judge/finding_text.hpp"

namespace farrier::diagnosis {
namespace {

constexpr double kFewShare = 0.01;             // of all rows
constexpr std::ptrdiff_t kFarthestPlace = 20;  // rows
constexpr double kMissing = 1.75;              // median intervals: more than jitter
constexpr double kShortGap = 4.5;              // median intervals: up to three samples are missing
constexpr double kStraying = 1.2;              // beyond the longest group of equal stamps

class Evener {
 public:
  Evener(std::vector<double>& time_s, std::vector<std::size_t>& line, const std::vector<TimedColumn>& columns)
      : rows_(time_s, line, columns), time_s_(time_s), line_(line), columns_(columns) {
    result_.added_error.assign(columns.size(), 0.0);
  }

  EvenTimes make() && {
    result_.findings = check_times(time_s_, line_);
    if (without_length(result_.findings).empty() || !can_be_tried()) {
      return std::move(result_);
    }
    const TimedRows::Copy before = rows_.copy();
    std::vector<Finding> as_read = std::move(result_.findings);
    result_.findings.clear();
    const bool evened = sort() && part_equal_times() && cut_at_gaps() && even_out();
    const std::vector<Finding> left = evened ? check_times(time_s_, line_) : as_read;
    if (left.empty()) {
      return std::move(result_);
    }
    rows_.restore(before);
    const bool was_short = std::ranges::any_of(as_read, is_length);
    if (evened && was_short) {
      result_.findings = left;  // its length alone is wrong
    } else {
      result_.remarks.clear();
      if (result_.findings.empty()) {
        result_.findings = std::move(as_read);
      }
    }
    return std::move(result_);
  }

 private:
  static bool is_length(const Finding& finding) { return finding.what == "too_short"; }
  static std::vector<Finding> without_length(std::vector<Finding> found) {
    std::erase_if(found, is_length);
    return found;
  }
  /// Findings in the times beside their length.
  std::vector<Finding> defects() const { return without_length(check_times(time_s_, line_)); }

  bool can_be_tried() const {
    return std::ranges::all_of(result_.findings, [](const Finding& finding) {
      return finding.what == "time_backwards" || finding.what == "duplicate_time" || finding.what == "gap" ||
             finding.what == "jitter" || finding.what == "uneven_sampling" || is_length(finding);
    });
  }

  /// False for rows too far from their place.
  bool sort() {
    std::size_t backwards = 0;
    for (std::size_t i = 1; i < time_s_.size(); ++i) {
      backwards += time_s_[i] < time_s_[i - 1] ? 1 : 0;
    }
    if (backwards == 0) {
      return true;
    }
    RowNumbers order(time_s_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t row) { return time_s_[row]; });
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (std::abs(static_cast<std::ptrdiff_t>(i) - static_cast<std::ptrdiff_t>(order[i])) > kFarthestPlace) {
        return false;
      }
    }
    if (static_cast<double>(backwards) > kFewShare * static_cast<double>(time_s_.size())) {
      return false;
    }
    rows_.keep(order);
    result_.remarks.push_back("Times go back in " + counted(backwards, "place") +
                              " by a few rows: the rows are sorted by their times.");
    return true;
  }

  bool part_equal_times() {
    RowNumbers kept;
    std::size_t repeated = 0;
    for (std::size_t i = 0; i < time_s_.size(); ++i) {
      const bool again = i > 0 && time_s_[i] == time_s_[i - 1] && rows_.same(i, i - 1);
      repeated += again ? 1 : 0;
      if (!again) {
        kept.push_back(i);
      }
    }
    std::size_t merged = 0, group = 1, longest = 1;
    for (std::size_t k = 1; k < kept.size(); ++k) {
      const bool equal = time_s_[kept[k]] == time_s_[kept[k - 1]];
      merged += equal ? 1 : 0;
      group = equal ? group + 1 : 1;
      longest = std::max(longest, group);
    }
    const bool coarse = static_cast<double>(merged) > kFewShare * static_cast<double>(kept.size());
    if (repeated > 0 && !coarse) {
      rows_.keep(kept);
      result_.remarks.push_back(counted(repeated, "row") + " repeated with the same time and values: left out.");
    }
    return coarse ? number_rows(longest) : take_last_of_equal(merged);
  }

  bool take_last_of_equal(std::size_t merged) {
    if (merged == 0) {
      return true;
    }
    RowNumbers kept;
    for (std::size_t i = 0; i < time_s_.size(); ++i) {
      if (i + 1 == time_s_.size() || time_s_[i + 1] != time_s_[i]) {
        kept.push_back(i);
      }
    }
    rows_.keep(kept);
    result_.remarks.push_back(counted(merged, "row") +
                              " with the time of the next row and other values: the later one is taken.");
    return true;
  }

  /// Times from the rows' numbers, where the stamps stray by no more than a group of equal ones explains.
  bool number_rows(std::size_t longest) {
    const TimeLine fit(time_s_);
    const double allowed_s = kStraying * static_cast<double>(longest + 1) * fit.period_s;
    if (!(fit.period_s > 0.0) || fit.straying_s > allowed_s) {
      return false;
    }
    set_times(fit);
    result_.remarks.push_back("Up to " + std::to_string(longest) +
                              " rows in a row have one time, as a coarse clock or samples that are sent together make "
                              "them: times follow from the rows' numbers, " +
                              rounded(fit.period_s) + " s apart. Lost samples would not show.");
    return passes();
  }

  bool cut_at_gaps() {
    const double median = median_step(time_s_);
    std::size_t short_gaps = 0, missing = 0;
    double longest_s = 0.0;
    for (std::size_t i = 1; i < time_s_.size(); ++i) {
      const double step = time_s_[i] - time_s_[i - 1];
      const bool is_short = step > kMissing * median && step <= kShortGap * median;
      short_gaps += is_short ? 1 : 0;
      missing += is_short ? static_cast<std::size_t>(std::lround(step / median)) - 1 : 0;
      longest_s = std::max(longest_s, step);
    }
    const bool fill = static_cast<double>(missing) <= kFewShare * static_cast<double>(time_s_.size());
    const double limit = (fill ? kShortGap : kGap) * median;
    std::size_t begin = 0, best_begin = 0, best_end = 0, gaps = 0;
    for (std::size_t i = 1; i <= time_s_.size(); ++i) {
      const bool ends = i == time_s_.size() || time_s_[i] - time_s_[i - 1] > limit;
      gaps += ends && i < time_s_.size() ? 1 : 0;
      if (ends && i - begin > best_end - best_begin) {
        best_begin = begin;
        best_end = i;
      }
      begin = ends ? i : begin;
    }
    if (gaps > 0) {
      RowNumbers rows(best_end - best_begin);
      std::iota(rows.begin(), rows.end(), best_begin);
      const std::size_t all = time_s_.size();
      rows_.keep(rows);
      result_.remarks.push_back("Samples are missing in " + counted(gaps, "place") + ", for up to " +
                                rounded(longest_s) + " s: of " + std::to_string(all) + " samples the " +
                                std::to_string(rows.size()) + " from line " + std::to_string(line_.front()) +
                                " on are taken, which have no gap.");
    }
    if (fill && short_gaps > 0) {
      result_.remarks.push_back(counted(missing, "sample") + " missing in " + counted(short_gaps, "place") +
                                ": filled by interpolation.");
    }
    return true;
  }

  bool even_out() {
    const std::vector<Finding> left = defects();
    if (left.empty()) {
      return true;
    }
    if (std::ranges::any_of(left, [](const Finding& finding) {
          return finding.what != "jitter" && finding.what != "uneven_sampling" && finding.what != "gap";
        })) {
      return false;
    }
    const double median = median_step(time_s_);
    double square = 0.0, most = 0.0;
    std::size_t counted_steps = 0;
    for (std::size_t i = 1; i < time_s_.size(); ++i) {
      const double off = (time_s_[i] - time_s_[i - 1]) / median - 1.0;
      if (off <= kGap - 1.0) {
        square += off * off;
        most = std::max(most, std::abs(off));
        ++counted_steps;
      }
    }
    const double rms = std::sqrt(square / static_cast<double>(std::max<std::size_t>(1, counted_steps)));
    if (rms > kMostJitter) {
      result_.findings.push_back({"uneven_sampling", left.front().row,
                                  "times stray from intervals of " + rounded(median) + " s by " + rounded(100.0 * rms) +
                                      " % (RMS), more than " + rounded(100.0 * kMostJitter) +
                                      " %, up to which samples are interpolated; record with a fixed period"});
      return false;
    }
    interpolate("Intervals stray from " + rounded(median) + " s by up to " + rounded(100.0 * most) + " % (RMS " +
                rounded(100.0 * rms) + " %): ");
    return passes();
  }

  void interpolate(const std::string& seen) {
    const TimeLine fit(time_s_);
    const auto periods =
        static_cast<std::size_t>(std::max(1.0, std::round((time_s_.back() - time_s_.front()) / mean_step(time_s_))));
    const EvenGrid grid(time_s_, periods);
    std::vector<std::vector<double>> carried;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      carried.push_back(grid.carry(*columns_[i].values, columns_[i].carry, result_.added_error[i]));
    }
    const bool stamps_stray = fit.straying_s <= fit.period_s && !columns_.empty() && carried.front().size() > 1 &&
                              white_noise(*columns_.front().values) < white_noise(carried.front());
    if (stamps_stray) {
      std::ranges::fill(result_.added_error, 0.0);
      set_times(fit);
      result_.remarks.push_back(seen + "the values are smoother at even times, " + rounded(fit.period_s) +
                                " s apart, so the stamps stray and not the samples. Values stay as they are.");
      return;
    }
    std::string errors;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      *columns_[i].values = std::move(carried[i]);
      if (result_.added_error[i] > 0.0) {
        errors += (errors.empty() ? "" : ", ") + rounded(result_.added_error[i]) + " in " + columns_[i].name;
      }
    }
    std::vector<std::size_t> lines;
    for (const std::size_t row : grid.rows()) {
      lines.push_back(line_[row]);
    }
    const double period_s = grid.period_s();
    time_s_ = grid.time_s();
    line_ = std::move(lines);
    result_.remarks.push_back(
        seen + "the samples are interpolated to even times, " + rounded(period_s) + " s apart." +
        (errors.empty() ? "" : " The error that this adds counts as noise: up to " + errors + " (RMS)."));
  }

  void set_times(const TimeLine& fit) {
    for (std::size_t i = 0; i < time_s_.size(); ++i) {
      time_s_[i] = fit.first_s + static_cast<double>(i) * fit.period_s;
    }
  }

  /// True if the times are good now.
  bool passes() const { return defects().empty(); }

  TimedRows rows_;
  std::vector<double>& time_s_;
  std::vector<std::size_t>& line_;
  const std::vector<TimedColumn>& columns_;
  EvenTimes result_;
};

}  // namespace

EvenTimes make_even(std::vector<double>& time_s, std::vector<std::size_t>& line,
                    const std::vector<TimedColumn>& columns) {
  return Evener(time_s, line, columns).make();
}

}  // namespace farrier::diagnosis
