#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "diagnosis/data/recording.hpp"
#include "diagnosis/data/timed_rows.hpp"

namespace farrier::diagnosis {

/// Changes of the times of a recording.
struct EvenTimes {
  std::vector<Finding> findings;     ///< not empty: the times cannot be used, and rows and columns are as before
  std::vector<std::string> remarks;  ///< sentences for the user, what was done and the error that it adds
  std::vector<double> added_error;   ///< RMS per column, in its unit; 0 where nothing was interpolated
};

/// Largest RMS of the intervals about their median, over the median, that is interpolated.
inline constexpr double kMostJitter = 0.2;

/// Makes the times (s) of rows on these lines even, where that can be done, and carries the columns to them. The first
/// column is a measured, smooth one. Times that check_times accepts stay as they are. Otherwise, in this order:
///
/// - Rows out of the order of their times, at most 1 % of all and 20 rows away from their place, are sorted.
/// - Repeated rows are left out. More than 1 % of other rows with the time of the row before come from a coarse clock or
///   from samples sent together. Times then follow from the rows' numbers, if the stamps stray by no more than the longest
///   such group explains. If they are fewer, the last is taken.
/// - The longest stretch without a gap is taken. Gaps of up to 3 samples, at most 1 % of all, count as
///   jitter.
/// - Times that stray with an RMS of up to kMostJitter are made even. If the first column is smoother at even times, the
///   stamps stray and not the samples, and the values stay. Otherwise they are interpolated by cubic Hermite polynomials
///   with slopes from three points. The added error is the RMS by which these differ from straight lines.
///
/// Fails as check_times does. All values must be finite.
EvenTimes make_even(std::vector<double>& time_s, std::vector<std::size_t>& line,
                    const std::vector<TimedColumn>& columns);

}  // namespace farrier::diagnosis
