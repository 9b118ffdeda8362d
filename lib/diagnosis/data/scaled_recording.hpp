#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"
#include "diagnosis/data/recording.hpp"

namespace farrier::diagnosis {

/// A valve and what it moves, in units of the file's own and without a time base: one sample after the other. Vectors
/// of one size, at least kFewestSamples; all values are finite, none beyond 1e6, and neither half of any is constant.
struct ScaledRecording {
  std::string source;                ///< the file's name, for messages
  std::vector<double> valve;         ///< opening that acts from its sample to the next; 0: shut
  std::vector<double> position;
  std::vector<std::string> remarks;  ///< what the reader made of the file: sentences for its user
};

/// Reads a CSV file with a header and the columns sample, valve and position, in the form that read_recording takes.
/// Samples count up by one, from any number. Other columns are ignored with a remark.
///
/// Refuses what read_recording says of the file and of its cells, and missing_column, not_whole, duplicate_sample,
/// sample_backwards, missing_sample, constant (throughout or over a half), out_of_range and too_short.
Result<ScaledRecording, RecordingProblems> read_scaled_recording(const std::string& path);

}  // namespace farrier::diagnosis
