#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "diagnosis/data/recording.hpp"

namespace farrier::diagnosis {

/// Returns the defects in the times of samples (s; NaN for a refused one, whose intervals are not judged) on these
/// lines of a file. The kinds are time_backwards, duplicate_time, gap, jitter, uneven_sampling, wrong_units, too_short.
/// Intervals are judged against their median: beyond 1.5 of it is a gap, off by more than 2 % is uneven.
std::vector<Finding> check_times(std::span<const double> time_s, std::span<const std::size_t> line);

/// Mean interval, s, of times in which nothing was found.
double period_of(std::span<const double> time_s);

}  // namespace farrier::diagnosis
